#include "corrections/Correction.H"

#include "pairs/PairLoop.H"

namespace sph
{

template class PairSum<Correction>;

} // namespace sph
