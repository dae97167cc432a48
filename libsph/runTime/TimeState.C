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
    value = dict.get("value", dimTime);
    index = std::int64_t(dict.get("index", dimless, Range::nonNegative()));
    deltaT = dict.get("deltaT", dimTime, Range::nonNegative());
    deltaTLimit = dict.getOrDefault
    (
        "deltaTLimit", deltaT, dimTime, Range::nonNegative()
    );
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
                << "index           " << index << ";\n\n"
                << "deltaT          " << deltaT << ";\n\n"
                << "deltaTLimit     " << deltaTLimit << ";\n";
        }
    );
}

} // namespace sph
