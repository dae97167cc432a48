#include "shifting/strainRate.H"

#include "pairs/PairLoop.H"

namespace sph
{

strainRate::strainRate
(
    const dictionary& dict, const Particles& particles, const Kernel& kernel
)
:
    AhSqr_
    (
        dict.getOrDefault
        (
            {"A", "strength"}, 1, dimless, Range::nonNegative()
        )
       *kernel.h()*kernel.h()
    ),
    lambdaMin_
    (
        dict.getOrDefault
        (
            {"lambdaMin", "lambda above which particles are shifted"}, 0.75,
            dimless, Range::between(0, 1)
        )
    ),
    pairing_(0.2/std::pow(kernel.W(particles.spacing()), 4))
{}

static const Shifting::Add<strainRate> add
(
    "strainRate", "shifting in proportion to the shear rate"
);

} // namespace sph
