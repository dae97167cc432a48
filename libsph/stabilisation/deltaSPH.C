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
        2*dict.getOrDefault("delta", 0.1, dimless, Range::nonNegative())
       *kernel.h()
    ),
    eos_(eos)
{}

static const Stabilisation::Add<deltaSPH> add
(
    "deltaSPH", "density diffusion of Antuono et al."
);

} // namespace sph
