#include "annotation/Specimen.H"

namespace sph
{

static const label n = 10;      // particles along and across the block


Specimen::Specimen(const scalar spacing)
:
    properties
    (
        dictionary::filledIn("rheology muI; turbulence laminar;")
    ),
    boundary(dictionary::filledIn("bed { type noSlip; }")),
    schemes(dictionary::filledIn("viscousScheme Morris;")),
    solution(dictionary::filledIn("")),
    particles(spacing),
    material(properties, g, spacing),
    boundaries(boundary, spacing),
    scheme(schemes, solution, particles, boundaries, material, g)
{
    const std::vector<WallParticle> walls = boundaries.wallParticles();
    particles.resize(n*n, label(walls.size()));
    const auto place = [&](const label i, const vector& r)
    {
        particles.id[i] = i;
        particles.r.set(i, r);
        particles.rho[i] = material.rho0();
        particles.V[i] = spacing*spacing;
        particles.m[i] = material.rho0()*particles.V[i];
    };
    for (label i = 0; i < n*n; ++i)
    {
        place(i, spacing*vector(i % n + 0.5, i/n + 0.5));
    }
    label i = particles.walls().begin;
    for (const WallParticle& wall : walls)
    {
        place(i, wall.r);
        particles.n.set(i, wall.n);
        particles.depth[i] = wall.depth;
        particles.patch[i] = wall.patch;
        ++i;
    }
    silence_.reset();
}

} // namespace sph
