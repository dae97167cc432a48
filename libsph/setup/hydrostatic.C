#include "setup/hydrostatic.H"

#include "setup/lithostatic.H"

#include <algorithm>
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

// Depth of every granular particle below the free surface [m]
static scalarField depths
(
    const std::vector<RegionParticles>& regions, const Particles& particles,
    const vector& up
)
{
    std::vector<const Region*> shapes;
    for (const RegionParticles& region : regions)
    {
        shapes.push_back(region.region.get());
    }
    scalarField z(particles.granular().end);
    for (label i = 0; i < particles.granular().end; ++i)
    {
        z[i] = distanceToBorder
        (
            shapes, particles.r[i], up, 0.5*particles.spacing()
        );
    }
    return z;
}

bool setHydrostatic
(
    const dictionary& dict, const vector& g, EquationOfState& equationOfState,
    const std::vector<RegionParticles>& regions, Particles& particles
)
{
    const Key hydrostatic("hydrostatic", "the start has the pressures of rest");
    if (!dict.getOrDefault(hydrostatic, true) || g.norm() == 0)
    {
        dict.markUsed("surfaceNormal");
        std::cout << "\nDensity rho0 everywhere\n";
        return false;
    }
    const vector up = readSurfaceNormal(dict, g);
    const scalar gn = -g.dot(up)*pressureByStress(dict);
    const scalarField z = depths(regions, particles, up);
    if (equationOfState.adaptive())
    {
        const scalar deepest = *std::max_element(z.begin(), z.end());
        const scalar needed =
            equationOfState.KFactor()*equationOfState.rho0()*gn*deepest;
        equationOfState.setK(std::max(equationOfState.K(), needed));
    }

    scalar greatest = 0;
    for (label i = 0; i < particles.granular().end; ++i)
    {
        const scalar p = hydrostaticPressure(equationOfState, gn, z[i]);
        particles.rho[i] = equationOfState.density(p);
        greatest = std::max(greatest, p);
    }
    std::cout
        << "\nHydrostatic density, pressure up to " << greatest << " Pa\n";
    return true;
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
