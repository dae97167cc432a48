#include "setup/regionParticles.H"

#include "runTime/log.H"

#include <cmath>
#include <iostream>
#include <set>
#include <sstream>

namespace sph
{

static void reportArea(const RegionParticles& region, const scalar dx)
{
    const scalar area = region.region->area();
    const scalar filled = region.points.size()*dx*dx;
    const scalar percent = 100*(filled/area - 1);

    std::cout
        << "Filling region " << region.name << " ("
        << region.dict->get<word>("type") << "): "
        << region.points.size() << " particles\n"
        << "    area " << area << " m2, particles " << filled << " m2, "
        << (std::abs(percent) < 1e-6 ? 0 : percent) << " %\n";

    if (std::abs(percent) > 1)
    {
        std::ostringstream text;
        text
            << "The particles of region '" << region.name << "' take "
            << std::abs(percent) << " % " << (percent > 0 ? "more" : "less")
            << " than its area: choose a spacing that divides its sides";
        warning(text.str());
    }
}

// A spacing in the wrong unit would fill the memory
static void checkSpacing
(
    const dictionary& dict, const scalar dx, const word& name,
    const Region& region
)
{
    const scalar cells = region.bounds().volume()/(dx*dx);
    if (cells > 1e8)
    {
        std::ostringstream text;
        text
            << "A spacing of " << dx << " m is too small for the region '"
            << name << "': about " << cells << " particles";
        dict.fail("spacing", text.str());
    }
}

std::vector<RegionParticles> fillRegions
(
    const dictionary& dict, const Lattice& lattice
)
{
    std::cout
        << "Lattice " << lattice.type() << ", spacing " << lattice.spacing()
        << " m\n\n";

    std::vector<RegionParticles> regions;
    std::set<word> names;
    const Key list
    (
        "regions", "regions to be filled, each with a name: see region",
        "(\n    column { type box; min (0 0 0); max (0.1 0.1 0); }\n)"
    );
    for (const auto& [listed, regionDict] : dict.dictList(list))
    {
        const word name =
            listed.empty() ? std::to_string(regions.size()) : listed;
        if (!names.insert(name).second)
        {
            regionDict->fail("", "There are two regions '" + name + "'");
        }
        std::unique_ptr<Region> shape = Region::New(*regionDict);
        checkSpacing(dict, lattice.spacing(), name, *shape);
        std::vector<vector> points = lattice.points(*shape);
        regions.push_back
        (
            {name, regionDict, std::move(shape), std::move(points)}
        );
        if (regions.back().points.empty())
        {
            std::ostringstream text;
            text
                << "The region '" << name << "' holds no particle: "
                << "with a spacing of " << lattice.spacing()
                << " m no lattice point lies inside\n\nLengths are in metres:"
                << " check spacing and the size of the region";
            regionDict->fail("", text.str());
        }
        reportArea(regions.back(), lattice.spacing());
    }
    if (regions.empty())
    {
        dict.fail("regions", "There is no region to be filled");
    }
    return regions;
}

} // namespace sph
