#include "particles/lanes.H"

namespace sph
{

template<class Lanes, bool single>
const bool LanesOfLibsph<Lanes, single>::present = true;

template struct LanesOfLibsph<lanes, singlePrecision>;

} // namespace sph
