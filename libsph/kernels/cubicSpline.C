#include "kernels/cubicSpline.H"

namespace sph
{

static const Kernel::Add<cubicSpline> add
(
    "cubicSpline", "M4 B-spline of support 2h, Eq. 10"
);

} // namespace sph
