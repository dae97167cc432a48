#include "selection/Libraries.H"

#include "selection/Selectable.H"

#include <dlfcn.h>

namespace sph
{

void loadLibraries
(
    const dictionary& controlDict, const std::filesystem::path& caseDir
)
{
    const Key libs("libs", "shared objects with models of your own");
    for (const word& name : controlDict.getOrDefault(libs, wordList()))
    {
        const bool isPath = name.find('/') != word::npos;
        const std::string file = isPath ? (caseDir/name).string() : name;
        if (!dlopen(file.c_str(), RTLD_NOW | RTLD_GLOBAL))
        {
            const char* error = dlerror();
            const std::string reason = error ? error : "";
            const bool otherLanes =
                reason.find("LanesOfLibsph") != std::string::npos;
            controlDict.fail
            (
                "libs", "Cannot load library " + name + "\n" + reason
              + (otherLanes ? "\nIt was compiled for other registers or"
                    " another precision than libsph: compile both with the"
                    " same -march and SPH_PRECISION" : "")
            );
        }
    }
    SelectionTables::checkUnique();
}

void loadLibrariesOfCase(const std::filesystem::path& caseDir)
{
    const std::filesystem::path file = caseDir/"system"/"controlDict";
    std::error_code ignored;
    if (std::filesystem::exists(file, ignored))
    {
        loadLibraries(dictionary::fromFile(file), caseDir);
    }
}

} // namespace sph
