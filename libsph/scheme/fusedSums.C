// The sums that a step is made of, in one pass each: those of the recommended
// scheme, and of schemes that leave out some of its terms. Any other selection
// works as well, in more passes.

#include "artificialViscosity/gradientCorrected.H"
#include "corrections/Correction.H"
#include "operators/DensityGradient.H"
#include "operators/StressDivergence.H"
#include "operators/VelocityGradient.H"
#include "pairs/FusedSums.H"
#include "shifting/strainRate.H"
#include "stabilisation/deltaSPH.H"

namespace sph
{

static const FusedSums::Add
<
    Correction, VelocityGradient, DensityGradient, strainRate
> gradients;

static const FusedSums::Add
<
    Correction, VelocityGradient, DensityGradient
> gradientsWithoutShifting;

static const FusedSums::Add
<
    Correction, VelocityGradient, strainRate
> gradientsWithoutDensity;

static const FusedSums::Add<Correction, VelocityGradient> velocityGradients;

static const FusedSums::Add
<
    StressDivergence, gradientCorrected, deltaSPH
> forces;

static const FusedSums::Add
<
    StressDivergence, gradientCorrected
> forcesWithoutDiffusion;

static const FusedSums::Add
<
    StressDivergence, deltaSPH
> forcesWithoutViscosity;

} // namespace sph
