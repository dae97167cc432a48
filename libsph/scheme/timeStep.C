#include "scheme/timeStep.H"

#include "runTime/log.H"
#include "scheme/ImplicitViscosity.H"

#include <cmath>
#include <iostream>

namespace sph
{

TimeStep::TimeStep
(
    const dictionary& solution, const Material& material, const scalar h
)
:
    material_(material),
    h_(h),
    viscousLimit_
    (
        solution.getOrDefault
        (
            {"viscousLimit", "steps keep to the viscous limit"}, true
        )
     && !material.rheology().elastic()
     && !ImplicitViscosity::selected(solution)
    ),
    viscousNumber_
    (
        solution.getOrDefault
        (
            {"viscousNumber", "viscous step limit over h^2/nu, Eq. 33"}, 0.1,
            dimless, Range::positive()
        )
    )
{}

scalar TimeStep::stable(const Particles& particles) const
{
    scalar step = h_/material_.cP();
    if (viscousLimit_)
    {
        const label n = particles.granular().end;
        scalar nuMax = 0;
        #pragma omp parallel for simd schedule(static) reduction(max: nuMax)
        for (label i = 0; i < n; ++i)
        {
            const scalar nu = particles.eta[i]/particles.rho[i];
            nuMax = nu > nuMax ? nu : nuMax;
        }
        if (nuMax > 0)
        {
            step = std::min(step, viscousNumber_*h_*h_/nuMax);
        }
    }
    return step;
}

void TimeStep::printCourant
(
    const Particles& particles, const scalar deltaT
) const
{
    const label n = particles.granular().end;
    const scalar* Ux = particles.U.x.data();
    const scalar* Uy = particles.U.y.data();
    scalar largest = 0, sum = 0;
    #pragma omp simd reduction(max: largest) reduction(+: sum)
    for (label i = 0; i < n; ++i)
    {
        const scalar magU = std::sqrt(Ux[i]*Ux[i] + Uy[i]*Uy[i]);
        largest = magU > largest ? magU : largest;
        sum += magU;
    }
    const scalar f = deltaT/h_, cP = material_.cP();
    stepLog() << "Courant Number mean: " << f*(cP + sum/std::max(n, 1))
        << " max: " << f*(cP + largest) << '\n';
}

} // namespace sph
