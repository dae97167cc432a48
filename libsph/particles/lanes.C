#include "particles/lanes.H"

namespace sph
{

template<label n>
const bool LanesOfLibsph<n>::present = true;

template struct LanesOfLibsph<width<lanes>>;

} // namespace sph
