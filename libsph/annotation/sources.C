#include "annotation/sources.H"

#include "functionObjects/FunctionObject.H"
#include "geometry/GeometryFormat.H"
#include "integrators/Integrator.H"
#include "regions/Region.H"
#include "runTime/TimeControls.H"
#include "runoutLaws/RunoutLaw.H"
#include "scheme/Guard.H"
#include "scheme/Sleep.H"
#include "scheme/timeStep.H"
#include "selection/Libraries.H"
#include "setup/readGravity.H"
#include "setup/setFieldValues.H"

namespace sph
{

namespace
{

Scene sceneOf(Specimen& specimen)
{
    return
    {
        "", "0", specimen.g, specimen.material.rho0(), specimen.particles,
        &specimen.scheme.wallForces(), nullptr, &specimen.material.rheology()
    };
}

void readSolution(const dictionary& dict, Specimen& specimen)
{
    Scheme scheme
    (
        specimen.schemes, dict, specimen.particles, specimen.boundaries,
        specimen.material, specimen.g
    );
    Integrator::New(dict);
    const scalar h = scheme.kernel().h();
    TimeStep(dict, specimen.material, h);
    Sleep
    (
        dict, {specimen.g, specimen.properties, specimen.boundary},
        specimen.particles, scheme.neighbourhood(), specimen.material.eos(), h
    );
    Guard(dict, specimen.particles, specimen.material);
}

void readControls(const dictionary& dict, Specimen& specimen)
{
    const TimeControls controls(dict);
    loadLibraries(dict, "");
    FunctionObjects(dict, sceneOf(specimen));
}

// Regions, each with its name
void readRegions(const dictionary& dict, Specimen& specimen)
{
    for (const word& name : dict.toc())
    {
        std::vector<RegionParticles> regions(1);
        regions[0].name = name;
        regions[0].dict = &dict.subDict(name);
        regions[0].region = Region::New(*regions[0].dict);
        regions[0].points.resize(specimen.particles.granular().size());
        setFieldValues(dict, regions, specimen.particles);
    }
}

} // namespace


std::vector<DictionarySource> dictionarySources(Specimen& specimen)
{
    const scalar dx = specimen.particles.spacing();
    return
    {
        {
            "controlDict", "system/controlDict",
            [&](const dictionary& dict) { readControls(dict, specimen); }
        },
        {
            "g", "constant/g",
            [](const dictionary& dict) { readGravity(dict); }
        },
        {
            "granularProperties", "constant/granularProperties",
            [&, dx](const dictionary& dict) { Material(dict, specimen.g, dx); }
        },
        {
            "sphSchemes", "system/sphSchemes",
            [&](const dictionary& dict)
            {
                Scheme
                (
                    dict, specimen.solution, specimen.particles,
                    specimen.boundaries, specimen.material, specimen.g
                );
            }
        },
        {
            "sphSolution", "system/sphSolution",
            [&](const dictionary& dict) { readSolution(dict, specimen); }
        }
    };
}


std::vector<FamilySource> familySources(Specimen& specimen)
{
    std::vector<FamilySource> families
    {
        {
            "boundary", "constant/boundary", "type",
            [&](const dictionary& dict)
            {
                Boundaries(dict, specimen.particles.spacing());
            }
        },
        {
            "functionObject", "functions of system/controlDict", "type",
            [&](const dictionary& dict)
            {
                FunctionObjects(sceneOf(specimen)).add(dict);
            }
        },
        {
            "region", "the list regions of system/setParticlesDict", "type",
            [&](const dictionary& dict) { readRegions(dict, specimen); }
        },
        {
            "geometryFormat", "geometry of a wall or a polygon", "format",
            [](const dictionary& dict)
            {
                GeometryFormat::New(dict, {"format", "kind of the file", "csv"}, "");
            }
        },
        {
            "runoutLaw", "system/postRunoutDict", "law",
            [](const dictionary& dict) { RunoutLaw::New(dict); }
        }
    };
    for (const DictionarySource& source : dictionarySources(specimen))
    {
        for (const ReadEntry& entry : explore("", source.read))
        {
            const word& family = entry.lookup.family;
            if (!family.empty())
            {
                families.push_back
                (
                    {family, source.place, entry.lookup.key.name, source.read}
                );
            }
        }
    }
    return families;
}

} // namespace sph
