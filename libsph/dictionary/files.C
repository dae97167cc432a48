#include "dictionary/files.H"

#include "primitives/error.H"

#include <dlfcn.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace sph
{

std::string readText(const std::filesystem::path& file)
{
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored))
    {
        throw IOError("cannot find file \"" + file.string() + '"', file);
    }
    std::ifstream is(file, std::ios::binary);
    std::ostringstream text;
    text << is.rdbuf();
    if (!is || std::filesystem::is_directory(file, ignored))
    {
        throw IOError("cannot read file \"" + file.string() + '"', file);
    }
    return text.str();
}

std::filesystem::path etcFolder()
{
    const char* const etc = std::getenv("SPH_ETC");
    if (etc && *etc)
    {
        return etc;
    }
    const char* const project = std::getenv("SPH_PROJECT_DIR");
    if (project && *project)
    {
        return std::filesystem::path(project)/"etc";
    }
    Dl_info library;
    static const char here = 0;
    if (dladdr(&here, &library))
    {
        const std::filesystem::path installed =
            std::filesystem::path(library.dli_fname).parent_path()
           /SPH_ETC_FROM_LIB;
        std::error_code ignored;
        if (std::filesystem::is_directory(installed, ignored))
        {
            return installed.lexically_normal();
        }
    }
    return SPH_ETC_DIR;
}

} // namespace sph
