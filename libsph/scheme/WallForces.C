#include "scheme/WallForces.H"

#include "pairs/FusedSums.H"

#include <algorithm>

namespace sph
{

template class PairSum<PressureGradient>;

WallForces::WallForces(Particles& particles, const Boundaries& boundaries)
:
    particles_(particles),
    stressDivergence_(vector::Zero()),
    walk_(particles),
    pressureWalk_(particles)
{
    const auto& patches = boundaries.patches();
    for (std::size_t k = 0; k < patches.size(); ++k)
    {
        if (!patches[k]->wallParticles().empty())
        {
            walls_[patches[k]->name()] = label(k);
        }
    }
    walk_.add(stressDivergence_);
    pressureWalk_.add(pressureGradient_);
}


void WallForces::make(const PairList& wallPairs, const Kernel& kernel)
{
    if (!watched_)
    {
        return;
    }
    walk_.run(wallPairs, kernel);
    take(total_);
    pressureWalk_.run(wallPairs, kernel);
    take(pressure_);
    known_ = true;
}


// m a of the walls, whose a is 0 again
void WallForces::take(vectorField& force)
{
    const ParticleRange range = particles_.walls();
    force.x.resize(range.size());
    force.y.resize(range.size());
    vectorField& a = particles_.a;
    for (label k = 0; k < range.size(); ++k)
    {
        const label w = range.begin + k;
        force.set(k, particles_.m[w]*a[w]);
    }
    for
    (
        label w = range.begin; w < range.begin + roundUpToLanes(range.size());
        ++w
    )
    {
        a.set(w, vector::Zero());
    }
}


WallForces::Force WallForces::on
(
    const std::vector<label>& patches, const vector& centre
) const
{
    Force sum;
    for (label k = 0; k < label(total_.x.size()); ++k)
    {
        const label w = particles_.walls().begin + k;
        if
        (
            std::find(patches.begin(), patches.end(), particles_.patch[w])
         == patches.end()
        )
        {
            continue;
        }
        const vector f = total_[k];
        const vector arm =
            particles_.r[w] + particles_.depth[w]*particles_.n[w] - centre;
        sum.pressure += pressure_[k];
        sum.shear += f - pressure_[k];
        sum.moment += arm.x()*f.y() - arm.y()*f.x();
    }
    return sum;
}

} // namespace sph
