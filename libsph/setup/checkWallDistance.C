#include "setup/checkWallDistance.H"

#include <cmath>
#include <map>
#include <sstream>

namespace sph
{

namespace
{

struct Misplaced
{
    label count = 0;
    scalar distance = 0;
    vector position = vector::Zero();
};

// By patch
std::map<word, Misplaced> findMisplaced
(
    const Boundaries& boundaries, const scalar dx,
    const std::vector<vector>& points
)
{
    std::map<word, Misplaced> misplaced;
    for (const vector& point : points)
    {
        const auto [distance, patch] = boundaries.distance(point);
        if (!patch.empty() && distance < leastWallDistance*dx)
        {
            Misplaced& found = misplaced[patch];
            if (found.count++ == 0 || distance < found.distance)
            {
                found.distance = distance;
                found.position = point;
            }
        }
    }
    return misplaced;
}

} // namespace


void checkWallDistance
(
    const Boundaries& boundaries, const scalar dx,
    const std::vector<RegionParticles>& regions
)
{
    for (const RegionParticles& region : regions)
    {
        const auto misplaced = findMisplaced(boundaries, dx, region.points);
        if (misplaced.empty())
        {
            continue;
        }
        std::ostringstream text;
        for (const auto& [patch, found] : misplaced)
        {
            text
                << found.count << " of " << region.points.size()
                << " particles of region '" << region.name
                << "' are behind patch '" << patch
                << "' or closer to it than a quarter of the spacing\n"
                << "    the worst at (" << found.position.x() << ' '
                << found.position.y() << " 0), "
                << std::abs(found.distance) << " m "
                << (found.distance < 0 ? "behind" : "in front of")
                << " it (spacing " << dx << " m)\n";
        }
        text
            << "\nThe material is on the left-hand side of a wall, walking"
               " from its first point to its last;\nthe normal of a"
               " symmetryPlane points into the material";
        region.dict->fail("", text.str());
    }
}

void jitter
(
    Lattice& lattice, const Boundaries& boundaries,
    std::vector<RegionParticles>& regions
)
{
    const scalar least = leastWallDistance*lattice.spacing();
    for (RegionParticles& region : regions)
    {
        lattice.shake
        (
            region.points,
            [&](const vector& point)
            {
                return boundaries.distance(point).first >= least;
            }
        );
    }
}

} // namespace sph
