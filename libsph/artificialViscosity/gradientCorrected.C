#include "artificialViscosity/gradientCorrected.H"

#include "pairs/PairLoop.H"

namespace sph
{

gradientCorrected::gradientCorrected
(
    const dictionary& dict, const EquationOfState& eos, const Kernel& kernel
)
:
    alpha_
    (
        dict.getOrDefault
        (
            {"alpha", "strength of the shear part, nu = alpha c h/8"}, 0.3,
            dimless, Range::nonNegative()
        )
    ),
    chi_
    (
        dict.getOrDefault
        (
            {"chi", "strength of the bulk part; chi maxCo <= 0.5"}, 1,
            dimless, Range::nonNegative()
        )
    ),
    h_(kernel.h()),
    eos_(eos)
{}

void gradientCorrected::bulkPressure
(
    Particles& particles, const ParticleRange& range
) const
{
    const scalar* div = particles.div.data();
    const scalar* p = particles.p.data();
    scalar* q = particles.q.data();
    const scalar bulk = chi_*eos_.rho0()*eos_.c()*h_;
    #pragma omp simd
    for (label i = range.begin; i < range.end; ++i)
    {
        const scalar limit = std::max(0.5*p[i], 0.0);
        q[i] = std::min(std::max(-bulk*div[i], -limit), limit);
    }
}

static const ArtificialViscosity::Add<gradientCorrected> add
(
    "gradientCorrected", "sub-grid viscosity without the linear part of U"
);

} // namespace sph
