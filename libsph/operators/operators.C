#include "operators/DensityGradient.H"
#include "operators/StressDivergence.H"
#include "operators/VelocityGradient.H"

#include "pairs/PairLoop.H"

namespace sph
{

template class PairSum<VelocityGradient>;
template class PairSum<DensityGradient>;
template class PairSum<StressDivergence>;

} // namespace sph
