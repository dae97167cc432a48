#include "setup/createParticles.H"

#include <algorithm>
#include <iostream>

namespace sph
{

std::vector<ParticleRange> rangesOf
(
    const std::vector<RegionParticles>& regions
)
{
    std::vector<ParticleRange> ranges;
    label end = 0;
    for (const RegionParticles& region : regions)
    {
        const label begin = end;
        end += label(region.points.size());
        ranges.push_back({begin, end});
    }
    return ranges;
}

void createParticles
(
    const std::vector<RegionParticles>& regions, const Boundaries& boundaries,
    const scalar rho0, Particles& particles
)
{
    const scalar dx = particles.spacing();
    const label nGranular = rangesOf(regions).back().end;
    particles.resize(nGranular, label(boundaries.wallParticles().size()));

    label i = 0;
    for (const RegionParticles& region : regions)
    {
        for (const vector& point : region.points)
        {
            particles.id[i] = i;
            particles.r.set(i, point);
            particles.rho[i] = rho0;
            particles.m[i] = rho0*dx*dx;
            ++i;
        }
    }
    boundaries.placeWalls(rho0, particles);
}

static void reportWalls
(
    const Boundaries& boundaries, const Particles& particles
)
{
    std::cout << "\nWall particles\n";
    const ParticleRange walls = particles.walls();
    for (std::size_t i = 0; i < boundaries.patches().size(); ++i)
    {
        std::cout
            << "    " << boundaries.patches()[i]->name() << ": "
            << std::count
               (
                   particles.patch.begin() + walls.begin,
                   particles.patch.begin() + walls.end, label(i)
               )
            << '\n';
    }
}

void reportParticles
(
    const std::vector<RegionParticles>& regions, const Boundaries& boundaries,
    const Particles& particles
)
{
    const std::vector<ParticleRange> ranges = rangesOf(regions);
    Region::Bounds extent;
    scalar totalMass = 0;

    std::cout << "\nGranular particles\n";
    for (std::size_t k = 0; k < regions.size(); ++k)
    {
        scalar mass = 0;
        for (label i = ranges[k].begin; i < ranges[k].end; ++i)
        {
            mass += particles.m[i];
            extent.extend(particles.r[i]);
        }
        totalMass += mass;
        std::cout
            << "    " << regions[k].name << ": " << ranges[k].size()
            << ", mass " << mass << " kg/m\n";
    }
    std::cout
        << "    total: " << particles.granular().size() << ", mass "
        << totalMass << " kg/m\n"
        << "    centres within ("
        << extent.min().x() << ' ' << extent.min().y() << " 0) ("
        << extent.max().x() << ' ' << extent.max().y() << " 0)\n";

    reportWalls(boundaries, particles);
}

} // namespace sph
