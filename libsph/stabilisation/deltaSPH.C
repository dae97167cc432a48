#include "stabilisation/deltaSPH.H"

#include "pairs/PairLoop.H"

namespace sph
{

deltaSPH::deltaSPH
(
    const dictionary& dict, const EquationOfState& eos, const Kernel& kernel
)
:
    twoDeltaH_
    (
        2*kernel.h()*dict.getOrDefault
        (
            {"delta", "strength of the density diffusion"}, 0.1,
            dimless, Range::nonNegative()
        )
    ),
    eos_(eos)
{}

static const Stabilisation::Add<deltaSPH> add
(
    "deltaSPH", "density diffusion of Antuono et al."
);

} // namespace sph
