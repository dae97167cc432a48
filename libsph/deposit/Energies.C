#include "deposit/Energies.H"

namespace sph
{

Energies::Energies
(
    const Particles& particles, const vector& g, const scalar rho0
)
{
    const auto [begin, end] = particles.granular();
    for (label i = begin; i < end; ++i)
    {
        const scalar m = particles.m[i];
        mass += m;
        momentum += m*particles.U[i];
        centreOfMass += m*particles.r[i];
        kinetic += 0.5*m*particles.U[i].squaredNorm();
        elastic += 0.5*m*particles.p[i]*(1/rho0 - 1/particles.rho[i]);
    }
    potential = -g.dot(centreOfMass);
    if (mass > 0)
    {
        centreOfMass /= mass;
    }
}

} // namespace sph
