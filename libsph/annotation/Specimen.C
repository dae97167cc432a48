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
    particles.resize(n*n, label(boundaries.wallParticles().size()));
    for (label i = 0; i < n*n; ++i)
    {
        particles.id[i] = i;
        particles.r.set(i, spacing*vector(i % n + 0.5, i/n + 0.5));
        particles.rho[i] = material.rho0();
        particles.V[i] = spacing*spacing;
        particles.m[i] = material.rho0()*particles.V[i];
    }
    boundaries.placeWalls(material.rho0(), particles);
    silence_.reset();
}

} // namespace sph
