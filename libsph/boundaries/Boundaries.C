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
    const std::vector<WallParticle> expected = wallParticles();
    const ParticleRange walls = particles.walls();
    bool same = walls.size() == label(expected.size());
    for (label w = 0; same && w < walls.size(); ++w)
    {
        const label i = walls.begin + w;
        same =
            particles.patch[i] == expected[w].patch
         && (particles.r[i] - expected[w].r).norm() < 1e-6*spacing_;
        particles.depth[i] = expected[w].depth;
    }
    if (!same)
    {
        throw Error
        (
            "The wall particles of the start time ("
          + std::to_string(walls.size()) + ") are not those of"
            " constant/boundary (" + std::to_string(expected.size())
          + "): it was changed, or walls.vtp is missing.\n"
            "Run setParticles again."
        );
    }
}

void Boundaries::check(const Particles& particles, const scalar reach) const
{
    for (const auto& patch : patches_)
    {
        patch->check(particles, reach);
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
