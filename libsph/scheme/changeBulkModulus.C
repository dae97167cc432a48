#include "scheme/changeBulkModulus.H"

#include <cmath>
#include <iostream>
#include <sstream>

namespace sph
{

static void setDensities
(
    const EquationOfState& eos, const ParticleRange& range,
    const bool granular, Particles& particles
)
{
    #pragma omp parallel for schedule(static)
    for (label i = range.begin; i < range.end; ++i)
    {
        if (particles.p[i] > 0)
        {
            particles.rho[i] = eos.density(particles.p[i]);
        }
        particles.V[i] = particles.m[i]/particles.rho[i];
        particles.Vg[i] = granular ? particles.V[i] : 0;
    }
}

void changeBulkModulus
(
    EquationOfState& eos, Particles& particles, const scalar K,
    const scalar magG
)
{
    const scalar before = eos.c();
    eos.correct(particles.granular(), particles.rho, particles.p);
    eos.setK(K);
    setDensities(eos, particles.granular(), true, particles);
    setDensities(eos, particles.walls(), false, particles);

    std::cout << "Sound speed " << before << " -> " << eos.c() << " m/s";
    if (eos.adaptive())
    {
        const scalar U = eos.c()/std::sqrt(eos.KFactor());
        std::cout << " (for speeds up to " << U
            << " m/s and pressure heads up to " << U*U/magG << " m)";
    }
    std::cout << '\n';
}

void checkPressures
(
    const EquationOfState& eos, const Particles& particles,
    const scalar greatest
)
{
    // Less is the rounding of rho0
    if (!(greatest > 1e-9*eos.K()))
    {
        return;
    }
    const scalar allowed = 0.01*greatest;
    for (label i = 0; i < particles.granular().end; ++i)
    {
        const scalar p = eos.pressure(particles.rho[i]);
        if (!(std::abs(p - particles.p[i]) <= allowed))
        {
            std::ostringstream os;
            os  << "Density and pressure of the start are not those of this"
                << " equation of state:\nparticle " << particles.id[i]
                << " has p = " << particles.p[i] << " Pa, but " << p
                << " Pa by its rho.\n\nRun setParticles again: the equation"
                << " of state was changed after it.";
            throw Error(os.str());
        }
    }
}

} // namespace sph
