#include "dictionary/files.H"

#include "primitives/error.H"

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
#ifdef SPH_ETC_DIR
    return SPH_ETC_DIR;
#else
    return {};
#endif
}

} // namespace sph
