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
    for (const word& name : controlDict.getOrDefault("libs", wordList()))
    {
        const bool isPath = name.find('/') != word::npos;
        const std::string file = isPath ? (caseDir/name).string() : name;
        if (!dlopen(file.c_str(), RTLD_NOW | RTLD_GLOBAL))
        {
            const char* reason = dlerror();
            controlDict.fail
            (
                "libs", "Cannot load library " + name + "\n"
              + (reason ? reason : "")
            );
        }
    }
    SelectionTables::checkUnique();
}

} // namespace sph
