#include "deposit/velocityArrows.H"

#include <cmath>
#include <set>

namespace sph
{

std::vector<VelocityArrow> velocityArrows
(
    const Particles& particles, const scalar width
)
{
    std::set<std::pair<label, label>> taken;
    std::vector<VelocityArrow> arrows;
    for (label i = 0; i < particles.granular().end; ++i)
    {
        const vector r = particles.r[i];
        const label column = label(std::floor(r.x()/width));
        const label row = label(std::floor(r.y()/width));
        if (taken.emplace(column, row).second)
        {
            arrows.push_back({r, particles.U[i]});
        }
    }
    return arrows;
}

} // namespace sph
