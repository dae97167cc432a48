#include "runTime/TimeState.H"

#include "dictionary/dictionary.H"
#include "primitives/writeFile.H"

#include <iomanip>
#include <ostream>

namespace sph
{

bool TimeState::read(const std::filesystem::path& timeFolder)
{
    const std::filesystem::path file = timeFolder/"uniform"/"time";
    if (!std::filesystem::exists(file))
    {
        return false;
    }
    const dictionary dict = dictionary::fromFile(file);
    if (dict.get<word>("name") != timeFolder.filename().string())
    {
        return false;
    }
    TimeState state;
    state.value = dict.get("value", dimTime);
    // Whole numbers up to here are exact
    state.index = std::int64_t
    (
        dict.get("index", dimless, Range::between(0, 9e15))
    );
    if (dict.found("timePrecision"))
    {
        state.timePrecision = label
        (
            dict.get("timePrecision", dimless, Range::between(1, 17))
        );
    }
    state.deltaT = dict.get("deltaT", dimTime, Range::nonNegative());
    state.deltaTLimit = dict.get("deltaTLimit", dimTime, Range::nonNegative());
    dict.refuseUnused();
    *this = state;
    return true;
}

void TimeState::write(const std::filesystem::path& timeFolder) const
{
    const std::string name = timeFolder.filename().string();
    writeFile
    (
        timeFolder/"uniform"/"time",
        [&](std::ostream& os)
        {
            os  << std::setprecision(17)
                << "FoamFile\n{\n"
                << "    version     2.0;\n"
                << "    format      ascii;\n"
                << "    class       dictionary;\n"
                << "    location    \"" << name << "/uniform\";\n"
                << "    object      time;\n"
                << "}\n\n"
                << "value           " << value << ";\n\n"
                << "name            \"" << name << "\";\n\n"
                << "index           " << index << ";\n\n";
            if (timePrecision > 0)
            {
                os  << "timePrecision   " << timePrecision << ";\n\n";
            }
            os  << "deltaT          " << deltaT << ";\n\n"
                << "deltaTLimit     " << deltaTLimit << ";\n";
        }
    );
}

} // namespace sph
