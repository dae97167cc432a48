#include "setup/readGravity.H"

namespace sph
{

// The factor from the entry dimensions to SI units
static scalar readUnit(const dictionary& dict)
{
    const std::string dimensions = dict.valueText
    (
        {"dimensions", "dimensions of an acceleration", "[0 1 -2 0 0 0 0]"}
    );
    try
    {
        return dictionary::fromString("unit " + dimensions + " 1;").get
        (
            "unit", dimAcceleration
        );
    }
    catch (const IOError&)
    {
        dict.fail
        (
            "dimensions",
            "The dimensions of an acceleration are " + dimAcceleration.str()
          + ", not " + dimensions
        );
    }
}

vector readGravity(const dictionary& dict)
{
    const scalar unit = readUnit(dict);
    const vector g = unit*dict.get<vector>
    (
        {"value", "gravity", "(0 -9.81 0)"}
    );
    dict.refuseUnused();
    return g;
}

vector readGravity(const std::filesystem::path& caseDir)
{
    return readGravity(dictionary::fromFile(caseDir/"constant"/"g"));
}

} // namespace sph
