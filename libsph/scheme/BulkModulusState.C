#include "scheme/BulkModulusState.H"

#include "dictionary/dictionary.H"
#include "primitives/writeFile.H"

#include <iomanip>
#include <ostream>

namespace sph
{

std::filesystem::path BulkModulusState::file
(
    const std::filesystem::path& timeFolder
)
{
    return timeFolder/"uniform"/"equationOfState";
}

std::optional<BulkModulusState> BulkModulusState::read
(
    const std::filesystem::path& timeFolder
)
{
    if (!std::filesystem::exists(file(timeFolder)))
    {
        return std::nullopt;
    }
    const dictionary dict = dictionary::fromFile(file(timeFolder));
    BulkModulusState state{dict.get("K", dimPressure, Range::positive())};
    if (dict.found("windowStart") || dict.found("windowRungs"))
    {
        state.window =
        {
            dict.get("windowStart", dimTime),
            // Of 10 %: down to K 1e-20, far below what any layer needs
            label
            (
                dict.get("windowRungs", dimless, Range::between(-500, 0))
            )
        };
    }
    dict.refuseUnused();
    return state;
}

void BulkModulusState::write(const std::filesystem::path& timeFolder) const
{
    writeFile
    (
        file(timeFolder),
        [&](std::ostream& os)
        {
            os  << std::setprecision(17)
                << "FoamFile\n{\n"
                << "    version     2.0;\n"
                << "    format      ascii;\n"
                << "    class       dictionary;\n"
                << "    location    \""
                << timeFolder.filename().string() << "/uniform\";\n"
                << "    object      equationOfState;\n"
                << "}\n\n";
            // K is last: a file that was cut short has none
            if (window)
            {
                os  << "windowStart     " << window->start << ";\n\n"
                    << "windowRungs     " << window->rungs << ";\n\n";
            }
            os  << "K               " << K << ";\n";
        }
    );
}

} // namespace sph
