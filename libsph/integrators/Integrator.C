#include "integrators/Integrator.H"

#include <cmath>

namespace sph
{

void Integrator::kick(Particles& particles, const scalar deltaT)
{
    scalar* Ux = particles.U.x.data();
    scalar* Uy = particles.U.y.data();
    const scalar* ax = particles.a.x.data();
    const scalar* ay = particles.a.y.data();
    const label n = particles.awake().end;
    #pragma omp parallel for simd schedule(static)
    for (label i = 0; i < n; ++i)
    {
        Ux[i] += deltaT*ax[i];
        Uy[i] += deltaT*ay[i];
    }
}

void Integrator::kickAndDrift
(
    Particles& particles, const scalar deltaTKick, const scalar deltaT
)
{
    scalar* x = particles.r.x.data();
    scalar* y = particles.r.y.data();
    scalar* Ux = particles.U.x.data();
    scalar* Uy = particles.U.y.data();
    const scalar* ax = particles.a.x.data();
    const scalar* ay = particles.a.y.data();
    const scalar* Usx = particles.Us.x.data();
    const scalar* Usy = particles.Us.y.data();
    const label n = particles.awake().end;
    const scalar maxUs = 0.05*particles.spacing()/deltaT;
    #pragma omp parallel for simd schedule(static)
    for (label i = 0; i < n; ++i)
    {
        Ux[i] += deltaTKick*ax[i];
        Uy[i] += deltaTKick*ay[i];
        const scalar magUs = std::sqrt(Usx[i]*Usx[i] + Usy[i]*Usy[i]);
        const scalar f = magUs > maxUs ? maxUs/magUs : 1;
        x[i] += deltaT*(Ux[i] + f*Usx[i]);
        y[i] += deltaT*(Uy[i] + f*Usy[i]);
    }
}

} // namespace sph
