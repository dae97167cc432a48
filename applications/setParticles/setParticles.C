// setParticles: fills regions with particles and writes the start time.
//
// Reads   system/setParticlesDict, system/controlDict, constant/boundary,
//         constant/g, constant/granularProperties
// Writes  <startTime>/granular.vtp, <startTime>/walls.vtp and, of a
//         hydrostatic start, <startTime>/uniform/equationOfState

#include "io/caseIO.H"
#include "io/writeTimeFolder.H"
#include "runTime/CaseLock.H"
#include "runTime/TimeControls.H"
#include "scheme/BulkModulusState.H"
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

static int setParticles(int argc, char* argv[])
{
    const CommandLine args
    (
        argc, argv,
        "Fills regions with particles, at rest under their own weight.",
        {
            {"dict", "file", "Use another dictionary than setParticlesDict"},
            {"time", "time", "Write this time instead of startTime"}
        }
    );
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
    const scalar rho0 = properties.get("rho0", dimDensity, Range::positive());
    const auto equationOfState = EquationOfState::New
    (
        properties, "equationOfState", rho0, g.norm()
    );

    Lattice lattice(dict);
    const scalar dx = lattice.spacing();
    Boundaries boundaries(dictionary::fromFile(constant/"boundary"), dx);
    boundaries.moveTo(time.value);

    auto regions = fillRegions(dict, lattice);
    resolveOverlaps(dict, dx, regions);
    checkWallDistance(boundaries, dx, regions);
    jitter(lattice, boundaries, regions);

    Particles particles(dx);
    createParticles(regions, boundaries, rho0, particles);
    checkBetweenPlanes(regions, boundaries, particles);
    const bool hydrostatic =
        setHydrostatic(dict, g, *equationOfState, regions, particles);
    setLithostatic(dict, g, properties, *equationOfState, particles);
    setFieldValues(dict, regions, particles);
    correctVolumeAndPressure(*equationOfState, particles);
    dict.refuseUnused();
    reportParticles(regions, boundaries, particles);

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
