// Wendland's C2 function, support 2h: positive Fourier transform, so that
// particles do not pair.
//
//     W = 7/(4 pi h^2) (1 - q/2)^4 (1 + 2 q),   q <= 2
//
// Wendland, Adv. Comput. Math. 4, 389 (1995).
//
//     kernel  WendlandC2;

#include "kernels/Kernel.H"

namespace sph
{
namespace
{

class WendlandC2 : public Kernel
{
public:
    WendlandC2(const dictionary&, const scalar h)
    :
        Kernel(h, 2)
    {}

    void evaluate
    (
        const label n, const scalar* rSqr, scalar* F, scalar* W
    ) const override
    {
        const scalar sigma = 7/(4*pi);
        evaluateRows
        (
            n, rSqr, F, W,
            [=](const lanes& q, const lanes&, lanes& f, lanes& w)
            {
                const lanes t = max(1 - 0.5*q, lanes(0));
                f = -5*sigma*t*t*t;
                w = sigma*t*t*t*t*(1 + 2*q);
            }
        );
    }
};

static const Kernel::Add<WendlandC2> add
(
    "WendlandC2", "Wendland's C2 function of support 2h"
);

} // namespace
} // namespace sph
