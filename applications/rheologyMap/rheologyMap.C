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

#include "annotation/writeEntries.H"
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
    const dictionary& dict, const Key& key, const label points
)
{
    const auto ends = dict.get<std::vector<scalar>>(key);
    if (ends.size() != 2 || !(ends[0] > 0) || !(ends[1] > ends[0]))
    {
        dict.fail(key.name, "Give two positive numbers, the lower one first");
    }
    scalarField values(points);
    for (label k = 0; k < points; ++k)
    {
        values[k] = ends[0]*std::pow(ends[1]/ends[0], scalar(k)/(points - 1));
    }
    return values;
}

// Where the viscosity is evaluated
struct MapPoints
{
    label points;           // of each
    scalarField p;          // [Pa]
    scalarField gammaDot;   // [1/s]

    explicit MapPoints(const dictionary& dict)
    :
        points
        (
            dict.getLabelOrDefault
            (
                {"points", "number of values of each, logarithmic"}, 61,
                Range{2}
            )
        ),
        p
        (
            logarithmic
            (
                dict,
                {"p", "least and greatest pressure [Pa]", "(1 2000)"}, points
            )
        ),
        gammaDot
        (
            logarithmic
            (
                dict,
                {
                    "gammaDot", "least and greatest shear rate [1/s]",
                    "(1e-3 1e3)"
                },
                points
            )
        )
    {}
};

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
        argc, argv, "Effective viscosity over pressure and shear rate.",
        {{"listEntries", "", "List all entries of rheologyMapDict and exit"}}
    );
    if (args.found("listEntries"))
    {
        writeDictionary
        (
            std::cout, "system/rheologyMapDict", "rheologyMap -listEntries",
            [](const dictionary& dict) { MapPoints{dict}; }
        );
        return 0;
    }
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

    const MapPoints map(dict);
    dict.refuseUnused();
    properties.refuseUnused();

    Particles particles(1);
    particles.resize(map.points, 0);
    for (label i = 0; i < map.points; ++i)
    {
        particles.rho[i] = material.rho0();
        particles.p[i] = map.p[i];
        particles.q[i] = 0;
    }

    OutputFolder folder(caseDir, "rheologyMap", "0");
    DataFile file
    (
        folder.path()/"eta.dat",
        {"p [Pa]  gammaDot [1/s]  eta = |s|/gammaDot [Pa s]  mu = |s|/p"},
        {"p", "gammaDot", "eta", "mu", "I"}
    );
    for (const scalar rate : map.gammaDot)
    {
        shear(material.rheology(), rate, particles);
        for (label i = 0; i < map.points; ++i)
        {
            const scalar tau =
                std::hypot(particles.s.xx[i], particles.s.xy[i]);
            file.write
            (
                {map.p[i], rate, tau/rate, tau/map.p[i], particles.I[i]}
            );
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
