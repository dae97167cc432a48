#include "geometry/GeometryFormat.H"

#include <algorithm>

namespace sph
{

namespace fs = std::filesystem;

static fs::path caseFolder(const dictionary& dict)
{
    fs::path folder = fs::absolute(dict.file()).parent_path();
    while (!fs::is_directory(folder/"system") && folder.has_relative_path())
    {
        folder = folder.parent_path();
    }
    return folder.has_relative_path() ? folder : fs::current_path();
}

std::unique_ptr<GeometryFormat> GeometryFormat::ofFile(const dictionary& dict)
{
    const fs::path given = dict.get<word>
    (
        {"file", "table or surface, from the case", "\"constant/bed.csv\""}
    );
    const fs::path path = (caseFolder(dict)/given).lexically_normal();
    if (!dict.fillsIn() && !fs::is_regular_file(path))
    {
        dict.fail
        (
            "file", "There is no file " + given.string() + "; looked for\n    "
          + path.string()
        );
    }
    word ending = path.extension().string();
    ending.erase(0, 1);
    std::transform
    (
        ending.begin(), ending.end(), ending.begin(),
        [](const unsigned char c) { return std::tolower(c); }
    );
    return New
    (
        dict, {"format", "kind of the file; else by the ending of its name"},
        ending.c_str(), path
    );
}

} // namespace sph
