#include "setup/hydrostatic.H"

#include <iostream>

namespace sph
{

scalar hydrostaticPressure
(
    const EquationOfState& equationOfState, const scalar gn, const scalar z
)
{
    // Classical Runge-Kutta
    constexpr label nSteps = 32;
    const scalar dz = z/nSteps;
    const auto slope = [&](const scalar p)
    {
        return equationOfState.density(p)*gn;
    };

    scalar p = 0;
    for (label step = 0; step < nSteps; ++step)
    {
        const scalar k1 = slope(p);
        const scalar k2 = slope(p + 0.5*dz*k1);
        const scalar k3 = slope(p + 0.5*dz*k2);
        const scalar k4 = slope(p + dz*k3);
        p += dz/6*(k1 + 2*k2 + 2*k3 + k4);
    }
    return p;
}

// Unit vector out of the free surface
static vector readSurfaceNormal(const dictionary& dict, const vector& g)
{
    const vector up = dict.getVectorOrDefault
    (
        "surfaceNormal", vector(-g.normalized()), dimless
    );
    if (!(up.dot(g) < 0))
    {
        dict.fail
        (
            "surfaceNormal",
            "The normal of the free surface must point against gravity"
        );
    }
    return up.normalized();
}

void setHydrostatic
(
    const dictionary& dict, const vector& g,
    const EquationOfState& equationOfState,
    const std::vector<RegionParticles>& regions, Particles& particles
)
{
    if (!dict.getOrDefault("hydrostatic", true) || g.norm() == 0)
    {
        dict.markUsed("surfaceNormal");
        std::cout << "\nDensity rho0 everywhere\n";
        return;
    }
    const vector up = readSurfaceNormal(dict, g);
    const scalar gn = -g.dot(up);

    std::vector<const Region*> shapes;
    for (const RegionParticles& region : regions)
    {
        shapes.push_back(region.region.get());
    }
    scalar deepest = 0;
    const ParticleRange granular = particles.granular();
    for (label i = granular.begin; i < granular.end; ++i)
    {
        const scalar z = distanceToBorder
        (
            shapes, particles.r[i], up, 0.5*particles.spacing()
        );
        const scalar p = hydrostaticPressure(equationOfState, gn, z);
        particles.rho[i] = equationOfState.density(p);
        deepest = std::max(deepest, p);
    }
    std::cout
        << "\nHydrostatic density, pressure up to " << deepest << " Pa\n";
}

void correctVolumeAndPressure
(
    const EquationOfState& equationOfState, Particles& particles
)
{
    const ParticleRange granular = particles.granular();
    for (label i = granular.begin; i < granular.end; ++i)
    {
        particles.V[i] = particles.m[i]/particles.rho[i];
    }
    equationOfState.correct(granular, particles.rho, particles.p);
}

} // namespace sph
