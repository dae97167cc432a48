#include "setup/checkBetweenPlanes.H"

#include "setup/createParticles.H"

namespace sph
{

void checkBetweenPlanes
(
    const std::vector<RegionParticles>& regions, const Boundaries& boundaries,
    const Particles& particles
)
{
    const std::vector<ParticleRange> ranges = rangesOf(regions);
    for (const auto& patch : boundaries.patches())
    {
        Particles wrapped(particles.spacing());
        wrapped.resize(particles.granular().size(), 0);
        for (label i = 0; i < wrapped.granular().end; ++i)
        {
            wrapped.r.set(i, particles.r[i]);
        }
        patch->wrap(wrapped);
        for (std::size_t k = 0; k < regions.size(); ++k)
        {
            label outside = 0;
            for (label i = ranges[k].begin; i < ranges[k].end; ++i)
            {
                outside += wrapped.r[i] != particles.r[i];
            }
            if (outside > 0)
            {
                regions[k].dict->fail
                (
                    "", std::to_string(outside) + " of "
                  + std::to_string(ranges[k].size())
                  + " particles of region '" + regions[k].name
                  + "' are not between the planes of patch '" + patch->name()
                  + "'\n\nMake the region, or the patch's translation, fit"
                );
            }
        }
    }
}

} // namespace sph
