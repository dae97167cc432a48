#include "settings.H"

#include "scheme/Material.H"
#include "setup/readGravity.H"

#include <algorithm>
#include <iostream>
#include <numeric>
#include <sstream>

namespace fs = std::filesystem;

namespace sph
{

static RunoutDict whole(const fs::path& path)
{
    std::cout << "Reading " << path.string() << "\n\n";
    return {dictionary::fromFile(path)};
}


// The entry of controlDict.functions of type runout, null if there is none
static const dictionary* runoutEntry(const dictionary& controlDict)
{
    const dictionary& functions = controlDict.subOrEmptyDict("functions");
    for (const word& name : functions.toc())
    {
        if (functions.isDict(name))
        {
            const dictionary& entry = functions.subDict(name);
            if (entry.getOrDefault<word>("type", "") == "runout")
            {
                std::cout
                    << "Reading entry functions." << name
                    << " of controlDict\n\n";
                return &entry;
            }
        }
    }
    return nullptr;
}


RunoutDict readRunoutDict(const CommandLine& args, const fs::path& caseDir)
{
    if (args.found("dict"))
    {
        const fs::path path = args.value("dict");
        return whole(fs::exists(path) ? path : caseDir/path);
    }
    const fs::path own = caseDir/"system"/"postRunoutDict";
    if (fs::exists(own))
    {
        return whole(own);
    }
    const fs::path control = caseDir/"system"/"controlDict";
    if (fs::exists(control))
    {
        RunoutDict read{dictionary::fromFile(control)};
        read.entry = runoutEntry(read.file);
        if (read.entry)
        {
            return read;
        }
    }
    std::cout
        << "No system/postRunoutDict and no function object runout:\n"
        << "L0 and H0 from the first time, no law\n\n";
    return {dictionary()};
}


void RunoutDict::refuseUnused() const
{
    if (!entry)
    {
        file.refuseUnused();
    }
}


static scalar readRho0
(
    const dictionary& dict, const fs::path& properties, const Particles& start
)
{
    const Key own
    (
        "rho0", "bulk density; else that of granularProperties, or the mean",
        "1600"
    );
    if (dict.found(own))
    {
        return dict.get(own, dimDensity, Range::positive());
    }
    if (fs::exists(properties))
    {
        return Material::readRho0(dictionary::fromFile(properties));
    }
    const label n = start.granular().size();
    return
        std::accumulate(start.rho.begin(), start.rho.begin() + n, 0.0)/n;
}


MaterialConstants readMaterial
(
    const dictionary& dict, const fs::path& caseDir, const Particles& start
)
{
    const fs::path properties = caseDir/"constant"/"granularProperties";
    const scalar rho0 = readRho0(dict, properties, start);
    const Key own("g", "gravity; else that of constant/g", "(0 -9.81 0)");
    const vector g =
        dict.found(own) ? dict.getVector(own, dimAcceleration)
      : fs::exists(caseDir/"constant"/"g") ? readGravity(caseDir)
      : vector(0, -9.81);
    return {rho0, g};
}


std::vector<Snapshot> findSnapshots
(
    const CommandLine& args, const fs::path& caseDir
)
{
    if (!args.found("vtp"))
    {
        return caseSnapshots(caseDir);
    }
    std::string text = args.valueOr("times", "");
    std::replace(text.begin(), text.end(), ',', ' ');
    std::istringstream is(text);
    std::vector<scalar> times;
    for (scalar time; is >> time; )
    {
        times.push_back(time);
    }
    if (!is.eof())
    {
        throw Error("-times '" + text + "' is no list of numbers");
    }
    return fileSnapshots(args.value("vtp"), times);
}

} // namespace sph
