// setParticles: fills regions with particles and writes the start time.
//
// Reads   system/setParticlesDict, system/controlDict, constant/boundary,
//         constant/g, constant/granularProperties
// Writes  <startTime>/granular.vtp, <startTime>/walls.vtp and, of a
//         hydrostatic start, <startTime>/uniform/equationOfState

#include "annotation/writeEntries.H"
#include "io/caseIO.H"
#include "io/writeTimeFolder.H"
#include "runTime/CaseLock.H"
#include "runTime/TimeControls.H"
#include "scheme/BulkModulusState.H"
#include "scheme/Material.H"
#include "selection/Libraries.H"
#include "setup/checkBetweenPlanes.H"
#include "setup/checkWallDistance.H"
#include "setup/createParticles.H"
#include "setup/hydrostatic.H"
#include "setup/lithostatic.H"
#include "setup/readGravity.H"
#include "setup/setFieldValues.H"
#include "setup/setupOptions.H"

#include <iostream>

using namespace sph;
namespace fs = std::filesystem;

// Regions, lattice, pressures and values, as the dictionary has them; whether
// the start is hydrostatic
static bool fill
(
    const dictionary& dict, const dictionary& boundary, const scalar time,
    const vector& g, const dictionary& properties,
    EquationOfState& equationOfState, Particles& particles
)
{
    Lattice lattice(dict);
    const scalar dx = lattice.spacing();
    Boundaries boundaries(boundary, dx);
    boundaries.moveTo(time);

    auto regions = fillRegions(dict, lattice);
    resolveOverlaps(dict, dx, regions);
    checkWallDistance(boundaries, dx, regions);
    jitter(lattice, boundaries, regions);

    particles.setSpacing(dx);
    createParticles(regions, boundaries, equationOfState.rho0(), particles);
    checkBetweenPlanes(regions, boundaries, particles);
    const bool hydrostatic =
        setHydrostatic(dict, g, equationOfState, regions, particles);
    setLithostatic(dict, g, properties, equationOfState, particles);
    setFieldValues(dict, regions, particles);
    correctVolumeAndPressure(equationOfState, particles);
    dict.refuseUnused();
    reportParticles(regions, boundaries, particles);
    return hydrostatic;
}

static int listEntries()
{
    const dictionary properties = dictionary::filledIn
    (
        "rheology elastoViscoplasticMuI;"
    );
    const dictionary boundary;
    const vector g(0, -9.81);
    const auto equationOfState = EquationOfState::New
    (
        properties, {"equationOfState", "", "linear"}, 1600, g.norm()
    );
    writeDictionary
    (
        std::cout, "system/setParticlesDict", "setParticles -listEntries",
        [&](const dictionary& dict)
        {
            Particles particles;
            fill
            (
                dict, boundary, 0, g, properties, *equationOfState, particles
            );
        }
    );
    return 0;
}

static int setParticles(int argc, char* argv[])
{
    const CommandLine args
    (
        argc, argv,
        "Fills regions with particles, at rest under their own weight.",
        {
            {"dict", "file", "Use another dictionary than setParticlesDict"},
            {"time", "time", "Write this time instead of startTime"},
            {"listEntries", "", "List all entries of setParticlesDict and exit"}
        }
    );
    if (args.found("listEntries"))
    {
        return listEntries();
    }
    const fs::path caseDir = args.caseDir();
    const CaseLock lock(caseDir);
    removeUnfinished(caseDir);
    const fs::path constant = caseDir/"constant";
    args.printBanner();

    const auto controlDict =
        dictionary::fromFile(caseDir/"system"/"controlDict");
    const TimeControls controls(controlDict);
    loadLibraries(controlDict, caseDir);
    const Time::Instant time = setupTime(args, controlDict);

    const fs::path dictPath = setupDictPath(args);
    std::cout << "Reading " << dictPath.filename() << '\n';
    const auto dict = dictionary::fromFile(dictPath);

    const vector g = readGravity(caseDir);
    const auto properties = dictionary::fromFile(constant/"granularProperties");
    const scalar rho0 = Material::readRho0(properties);
    const auto equationOfState = EquationOfState::New
    (
        properties, "equationOfState", rho0, g.norm()
    );

    Particles particles;
    const bool hydrostatic = fill
    (
        dict, dictionary::fromFile(constant/"boundary"), time.value, g,
        properties, *equationOfState, particles
    );

    std::cout << "\nWriting particles to \"" << time.name << "\"\n";
    writeTimeFolder
    (
        caseDir/time.name,
        [&](const fs::path& folder)
        {
            if (hydrostatic)
            {
                BulkModulusState{equationOfState->K()}.write(folder);
            }
            writeState
            (
                particles, time.value, folder,
                {
                    controls.writeAscii, controls.writeCompressed,
                    controls.writePrecision
                }
            );
        }
    );
    writeSeries(caseDir);
    warnOfLaterTimes(caseDir, time);

    std::cout << "\nEnd\n" << std::endl;
    return 0;
}

int main(int argc, char* argv[])
{
    return runMain("setParticles", [&]{ return setParticles(argc, argv); });
}
