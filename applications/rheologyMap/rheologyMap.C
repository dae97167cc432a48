// rheologyMap: the effective viscosity of a case's material in steady shear,
// over pressure and shear rate.
//
// Reads   constant/granularProperties, constant/g, system/rheologyMapDict:
//
//             p           (1 2000);       // [Pa] least and greatest
//             gammaDot    (1e-3 1e3);     // [1/s]
//             points      61;             // of each, logarithmic
//
// Writes  postProcessing/rheologyMap/0/eta.dat: p, gammaDot, eta = |s|/gammaDot,
//         |s|/p and I

#include "functionObjects/DataFile.H"
#include "runTime/CommandLine.H"
#include "runTime/TimeControls.H"
#include "scheme/Material.H"
#include "selection/Libraries.H"
#include "setup/readGravity.H"

#include <cmath>
#include <iostream>

using namespace sph;
namespace fs = std::filesystem;

static scalarField logarithmic
(
    const dictionary& dict, const word& name, const label points
)
{
    const auto ends = dict.get<std::vector<scalar>>(name);
    if (ends.size() != 2 || !(ends[0] > 0) || !(ends[1] > ends[0]))
    {
        dict.fail(name, "Give two positive numbers, the lower one first");
    }
    scalarField values(points);
    for (label k = 0; k < points; ++k)
    {
        values[k] = ends[0]*std::pow(ends[1]/ends[0], scalar(k)/(points - 1));
    }
    return values;
}

// Simple shear of all particles, until their stress stands still
static void shear
(
    const Rheology& rheology, const scalar gammaDot, Particles& particles
)
{
    scalar pMax = 0;
    for (label i = 0; i < particles.granular().end; ++i)
    {
        pMax = std::max(pMax, particles.p[i]);
        particles.gammaDot[i] = gammaDot;
        particles.gradU.set(i, (tensor() << 0, gammaDot, 0, 0).finished());
        particles.s.set(i, tensor::Zero());
    }
    const label steps = rheology.elastic() ? 2000 : 1;
    const scalar strain = rheology.elastic() ? 20*pMax/rheology.G() : 0;
    for (label step = 0; step < steps; ++step)
    {
        rheology.correct
        (
            particles, particles.granular(), strain/(steps*gammaDot)
        );
    }
}

static int rheologyMap(int argc, char* argv[])
{
    const CommandLine args
    (
        argc, argv, "Effective viscosity over pressure and shear rate.", {}
    );
    const fs::path caseDir = args.caseDir();
    args.printBanner();
    loadLibraries
    (
        dictionary::fromFile(caseDir/"system"/"controlDict"), caseDir
    );
    const auto dict =
        dictionary::fromFile(caseDir/"system"/"rheologyMapDict");
    const auto properties =
        dictionary::fromFile(caseDir/"constant"/"granularProperties");
    const Material material(properties, readGravity(caseDir), 1);

    const label points = dict.getOrDefault<label>("points", 61);
    if (points < 2)
    {
        dict.fail("points", "At least two points of each");
    }
    const scalarField p = logarithmic(dict, "p", points);
    const scalarField gammaDot = logarithmic(dict, "gammaDot", points);
    dict.refuseUnused();
    properties.refuseUnused();

    Particles particles(1);
    particles.resize(points, 0);
    for (label i = 0; i < points; ++i)
    {
        particles.rho[i] = material.rho0();
        particles.p[i] = p[i];
        particles.q[i] = 0;
    }

    OutputFolder folder(caseDir, "rheologyMap", "0");
    DataFile file
    (
        folder.path()/"eta.dat",
        {"p [Pa]  gammaDot [1/s]  eta = |s|/gammaDot [Pa s]  mu = |s|/p"},
        {"p", "gammaDot", "eta", "mu", "I"}
    );
    for (const scalar rate : gammaDot)
    {
        shear(material.rheology(), rate, particles);
        for (label i = 0; i < points; ++i)
        {
            const scalar tau =
                std::hypot(particles.s.xx[i], particles.s.xy[i]);
            file.write({p[i], rate, tau/rate, tau/p[i], particles.I[i]});
        }
    }
    std::cout << "Columns: " << folder.path().string() << "\n\nEnd\n"
        << std::endl;
    return 0;
}

int main(int argc, char* argv[])
{
    return runMain("rheologyMap", [&]{ return rheologyMap(argc, argv); });
}
