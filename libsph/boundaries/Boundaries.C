#include "boundaries/Boundaries.H"

#include "boundaries/Places.H"
#include "particles/team.H"

#include <algorithm>

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
                Boundary::New
                (
                    dict.subDict(name), {"type", "kind of patch"},
                    name, spacing
                )
            );
        }
    }
    if (anyMoves())
    {
        drawn_ = drawnParticles();
    }
    moveTo(0);
}

bool Boundaries::anyMoves() const
{
    return std::any_of
    (
        patches_.begin(), patches_.end(),
        [](const auto& patch) { return patch->moves(); }
    );
}

bool Boundaries::anyFriction() const
{
    return std::any_of
    (
        patches_.begin(), patches_.end(),
        [](const auto& patch) { return patch->muWall() > 0; }
    );
}

// In the order of the patches
std::vector<WallParticle> Boundaries::drawnParticles() const
{
    Places places(0.6*spacing_);
    std::vector<std::vector<WallParticle>> ofPatch(patches_.size());
    for (const bool moving : {false, true})
    {
        for (label p = 0; p < label(patches_.size()); ++p)
        {
            if (patches_[p]->moves() != moving)
            {
                continue;
            }
            for (WallParticle& w : patches_[p]->wallParticles())
            {
                if (places.free(w.r))
                {
                    w.patch = p;
                    ofPatch[p].push_back(w);
                }
            }
            for (const WallParticle& w : ofPatch[p])
            {
                places.take(w.r);
            }
        }
    }
    std::vector<WallParticle> all;
    for (const auto& particles : ofPatch)
    {
        all.insert(all.end(), particles.begin(), particles.end());
    }
    return all;
}

std::vector<WallParticle> Boundaries::wallParticles() const
{
    std::vector<WallParticle> all = drawnParticles();
    for (WallParticle& w : all)
    {
        w.r += patches_[w.patch]->displacement();
    }
    return all;
}

void Boundaries::placeWalls(const scalar rho0, Particles& particles) const
{
    label i = particles.walls().begin;
    std::int64_t id = particles.granular().end;
    for (const WallParticle& wall : wallParticles())
    {
        particles.id[i] = id++;
        particles.r.set(i, wall.r);
        particles.n.set(i, wall.n);
        particles.depth[i] = wall.depth;
        particles.patch[i] = wall.patch;
        particles.rho[i] = rho0;
        particles.V[i] = wall.share*spacing_*spacing_;
        particles.m[i] = rho0*particles.V[i];
        ++i;
    }
}

void Boundaries::moveTo(const scalar time)
{
    for (const auto& patch : patches_)
    {
        patch->moveTo(time);
    }
}

void Boundaries::moveTo(const scalar time, Particles& particles)
{
    moveTo(time);
    for (std::size_t k = 0; k < drawn_.size(); ++k)
    {
        const Boundary& patch = *patches_[drawn_[k].patch];
        if (patch.moves())
        {
            const label w = particles.walls().begin + label(k);
            particles.r.set(w, drawn_[k].r + patch.displacement());
            particles.Umean.set(w, patch.motion());
        }
    }
}

void Boundaries::setDepths(Particles& particles) const
{
    const std::vector<WallParticle> expected = wallParticles();
    const ParticleRange walls = particles.walls();
    bool same = walls.size() == label(expected.size());
    // An ASCII file may have few digits
    for (label w = 0; same && w < walls.size(); ++w)
    {
        const label i = walls.begin + w;
        same =
            particles.patch[i] == expected[w].patch
         && (particles.r[i] - expected[w].r).norm() < 1e-3*spacing_;
        particles.depth[i] = expected[w].depth;
    }
    if (walls.size() == 0 && !expected.empty())
    {
        throw Error
        (
            "There are no wall particles at the start time: its walls.vtp is"
            " missing.\n\nRemove this time folder to start from the one before"
            " it, or run setParticles."
        );
    }
    if (!same)
    {
        throw Error
        (
            "The wall particles of the start time ("
          + std::to_string(walls.size()) + ") are not those of"
            " constant/boundary (" + std::to_string(expected.size())
          + "): it was changed.\nRun setParticles again."
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
    shareOut
    (
        particles.awake(),
        [&](const ParticleRange& some)
        {
            for (const auto& patch : patches_)
            {
                const label caught = patch->net(particles, some);
                #pragma omp atomic
                hits += caught;
            }
        }
    );
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
