#include "boundaries/Boundaries.H"

namespace sph
{

Boundaries::Boundaries(const dictionary& dict, const scalar spacing)
:
    spacing_(spacing)
{
    for (const word& name : dict.toc())
    {
        if (name != "FoamFile" && dict.isDict(name))
        {
            patches_.push_back
            (
                Boundary::New(dict.subDict(name), "type", name, spacing)
            );
        }
    }
}

std::vector<WallParticle> Boundaries::wallParticles() const
{
    const scalar tooNearSqr = 0.36*spacing_*spacing_;
    std::vector<WallParticle> all;
    for (label p = 0; p < label(patches_.size()); ++p)
    {
        const std::size_t others = all.size();
        for (WallParticle w : patches_[p]->wallParticles())
        {
            bool free = true;
            for (std::size_t i = 0; free && i < others; ++i)
            {
                free = (all[i].r - w.r).squaredNorm() > tooNearSqr;
            }
            if (free)
            {
                w.patch = p;
                all.push_back(w);
            }
        }
    }
    return all;
}

void Boundaries::setDepths(Particles& particles) const
{
    const ParticleRange walls = particles.walls();
    for (label i = walls.begin; i < walls.end; ++i)
    {
        const label patch = particles.patch[i];
        if (patch < 0 || patch >= label(patches_.size()))
        {
            throw Error
            (
                "Wall particle " + std::to_string(particles.id[i])
              + " belongs to patch " + std::to_string(patch) + ", but"
                " constant/boundary has " + std::to_string(patches_.size())
              + " patches: run setParticles again"
            );
        }
        particles.depth[i] =
            std::max(0.0, -patches_[patch]->distance(particles.r[i]));
    }
}

label Boundaries::net(Particles& particles) const
{
    label hits = 0;
    for (const auto& patch : patches_)
    {
        hits += patch->net(particles);
    }
    return hits;
}

std::pair<scalar, word> Boundaries::distance(const vector& point) const
{
    std::pair<scalar, word> nearest
    {
        std::numeric_limits<scalar>::infinity(), word()
    };
    for (const auto& patch : patches_)
    {
        const scalar d = patch->distance(point);
        if (d < nearest.first)
        {
            nearest = {d, patch->name()};
        }
    }
    return nearest;
}

} // namespace sph
