#include "io/settings.H"

#include "primitives/writeFile.H"

#include <ostream>

namespace sph
{

void printSettings(std::ostream& os, const std::vector<Setting>& settings)
{
    for (const auto& [file, dict] : settings)
    {
        os << "\n// * * * " << file << "\n\n";
        dict.writeEffective(os);
    }
}

void writeSettings
(
    const std::filesystem::path& dir, const std::vector<Setting>& settings
)
{
    for (const Setting& setting : settings)
    {
        writeFile
        (
            dir/setting.file,
            [&](std::ostream& os) { setting.dict.writeEffective(os); }
        );
    }
}

} // namespace sph
