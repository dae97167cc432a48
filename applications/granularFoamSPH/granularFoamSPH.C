// Flow of dry granular material: weakly compressible SPH in two dimensions.
//
// One step, after Salehizadeh & Shafiei, Granular Matter 21:32 (2019), whose
// equation numbers stand at the calls.

#include "advise.H"
#include "estimate.H"
#include "lists.H"
#include "postProcess.H"

#include "boundaries/Boundaries.H"
#include "functionObjects/FunctionObject.H"
#include "integrators/Integrator.H"
#include "io/caseIO.H"
#include "io/settings.H"
#include "io/writeTimeFolder.H"
#include "runTime/CaseLock.H"
#include "runTime/CommandLine.H"
#include "runTime/Progress.H"
#include "runTime/Time.H"
#include "runTime/log.H"
#include "scheme/Doubts.H"
#include "scheme/Guard.H"
#include "scheme/Scheme.H"
#include "scheme/Sleep.H"
#include "scheme/SoundSpeed.H"
#include "scheme/timeStep.H"
#include "selection/Libraries.H"
#include "setup/readGravity.H"

#include <iostream>
#include <optional>

using namespace sph;
namespace fs = std::filesystem;

static void write
(
    const Particles& particles, const SoundSpeed& soundSpeed,
    const Sleep& sleep, const FunctionObjects& functions, Time& runTime
)
{
    writeTimeFolder
    (
        runTime.timePath(),
        [&](const fs::path& folder)
        {
            soundSpeed.write(folder);
            sleep.write(folder);
            functions.write(folder);
            runTime.writeState(folder);
            writeState
            (
                particles, runTime.value(), folder,
                {
                    runTime.writeAscii(), runTime.writeCompressed(),
                    runTime.writePrecision()
                }
            );
        }
    );
    runTime.wroteState();
    writeSeries(runTime.caseDir());
}

int main(int argc, char* argv[])
{
    return runMain("granularFoamSPH", [&]
    {
        std::vector<CommandLine::Option> options
        {
            {
                "dry-run", "",
                "check the case, print settings and estimates, and exit"
            },
            {"noFunctionObjects", "", "do not execute function objects"},
            adviseOption()
        };
        for (const auto& more : {listOptions(), postProcessOptions()})
        {
            options.insert(options.end(), more.begin(), more.end());
        }
        const CommandLine args
        (
            argc, argv, "Flow of dry granular material by SPH", options
        );
        if (list(args))
        {
            return 0;
        }
        const bool onlyPostProcess = postProcessing(args);
        args.printBanner();
        if (args.found("advise"))
        {
            advise(args);
            std::cout << "\nEnd\n" << std::endl;
            return 0;
        }
        if (onlyPostProcess)
        {
            postProcess(args);
            std::cout << "\nEnd\n" << std::endl;
            return 0;
        }

        const fs::path caseDir = args.caseDir();
        std::optional<CaseLock> lock;
        if (!args.found("dry-run"))
        {
            lock.emplace(caseDir);
            removeUnfinished(caseDir);
        }
        Time runTime(caseDir);
        loadLibraries(runTime.controlDict(), caseDir);
        const dictionary properties =
            dictionary::fromFile(caseDir/"constant"/"granularProperties");
        const dictionary boundary =
            dictionary::fromFile(caseDir/"constant"/"boundary");
        const dictionary schemes =
            dictionary::fromFile(caseDir/"system"/"sphSchemes");
        const dictionary solution =
            dictionary::fromFile(caseDir/"system"/"sphSolution");
        const dictionary gravity =
            dictionary::fromFile(caseDir/"constant"/"g");
        const vector g = readGravity(gravity);

        Particles particles;
        const bool complete = readState(runTime.timePath(), particles);
        const bool restart = complete && runTime.index() > 0;
        Material material(properties, g, particles.spacing());
        Boundaries boundaries(boundary, particles.spacing());
        boundaries.moveTo(runTime.value());
        Scheme scheme
        (
            schemes, solution, particles, boundaries, material, g
        );
        const auto integrator = Integrator::New(solution);
        std::cout << "Selecting integrator "
            << solution.get<word>("integrator") << '\n';
        const TimeStep timeStep(solution, material, scheme.kernel().h());
        Sleep sleep
        (
            solution, {g, properties, boundary}, particles,
            scheme.neighbourhood(), material.eos(), scheme.kernel().h()
        );
        Guard guard(solution, particles, material);
        Doubts doubts(particles, material);

        boundaries.setDepths(particles);
        SoundSpeed soundSpeed(material.eos(), g, particles, runTime.value());
        if (runTime.index() == 0)
        {
            soundSpeed.start(runTime.timePath());
        }
        else
        {
            soundSpeed.read(runTime.timePath());
        }
        sleep.start(runTime.timePath(), restart);
        const dictionary none;
        FunctionObjects functions
        (
            args.found("noFunctionObjects") ? none : runTime.controlDict(),
            Scene
            {
                caseDir, runTime.startTimeName(), g,
                material.rho0(), particles, &scheme.wallForces(), nullptr,
                &material.rheology()
            }
        );
        if (args.found("noFunctionObjects"))
        {
            runTime.controlDict().markUsed("functions");
        }
        for
        (
            const dictionary* dict :
            {
                &properties, &boundary, &schemes, &solution,
                &runTime.controlDict()
            }
        )
        {
            dict->refuseUnused();
        }
        const std::vector<Setting> settings
        {
            {"constant/granularProperties", properties},
            {"constant/boundary", boundary},
            {"constant/g", gravity},
            {"system/sphSchemes", schemes},
            {"system/sphSolution", solution},
            {"system/controlDict", runTime.controlDict()}
        };

        label netHits = 0;
        const auto step = [&](const scalar time, const scalar dt)
        {
            integrator->begin(particles, dt);       // (27)-(28)
            boundaries.moveTo(time, particles);
            netHits += boundaries.net(particles);
            sleep.update(dt, runTime.index());
            scheme.updatePairs();
            scheme.extrapolateVelocity();           // (21)-(23)
            scheme.gradients();                     // (11)-(13)
            scheme.correctMaterial(dt);             // (27), (7), (35)-(39)
            scheme.extrapolateStress();             // (24)-(26)
            scheme.forces(dt);                      // (14)-(20), (31)-(32)
            integrator->end(particles, dt);
            if (soundSpeed.follow(time))            // K, and rho for p
            {
                scheme.neighbourhood().reset();
            }
        };

        if (!restart)
        {
            scheme.initialise();
        }
        guard.keep(particles, runTime.value(), true);
        if (args.found("dry-run"))
        {
            printSettings(std::cout, settings);
            if (runTime.run())
            {
                runTime.setDeltaT(timeStep.stable(particles));
            }
            printEstimate(runTime, particles, timeStep, step);
            std::cout << "\nEnd\n" << std::endl;
            return 0;
        }
        writeSettings
        (
            caseDir/"effective"/runTime.startTimeName(), settings
        );
        if (restart)
        {
            functions.read(runTime.timePath(), runTime);
        }
        else
        {
            functions.execute(runTime, true);
        }

        std::cout << "\nStarting time loop: "
            << particles.granular().size() << " granular and "
            << particles.walls().size() << " wall particles\n" << std::endl;
        std::optional<Progress> progress;
        progress.emplace(runTime, particles.granular().size());
        while (runTime.loop(timeStep.stable(particles)))
        {
            const scalar dt = runTime.deltaT();
            step(runTime.value(), dt);

            timeStep.printCourant(particles, dt);
            stepLog() << "Pair lists rebuilt: "
                << scheme.neighbourhood().rebuilds()
                << "  wall net hits: " << netHits << '\n';
            guard.check(particles, runTime);
            doubts.look(runTime.value(), netHits);
            functions.execute(runTime);
            if (runTime.writeTime())
            {
                write(particles, soundSpeed, sleep, functions, runTime);
                guard.keep(particles, runTime.value(), true);
                scheme.neighbourhood().reset();
            }
            runTime.printExecutionTime();
            progress->step();
        }
        progress.reset();

        functions.end();
        sleep.printSummary();
        doubts.end();
        std::cout << "End\n" << std::endl;
        return 0;
    });
}
