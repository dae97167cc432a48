#include "deposit/Energies.H"

namespace sph
{

Energies::Energies
(
    const Particles& particles, const vector& g, const scalar K
)
{
    const auto [begin, end] = particles.granular();
    for (label i = begin; i < end; ++i)
    {
        const scalar m = particles.m[i], p = particles.p[i];
        mass += m;
        momentum += m*particles.U[i];
        centreOfMass += m*particles.r[i];
        kinetic += 0.5*m*particles.U[i].squaredNorm();
        if (K > 0)
        {
            elastic += m/particles.rho[i]*p*p/(2*K);
        }
    }
    potential = -g.dot(centreOfMass);
    if (mass > 0)
    {
        centreOfMass /= mass;
    }
}

} // namespace sph
