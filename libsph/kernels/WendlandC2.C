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

class WendlandC2 : public KernelShape<WendlandC2>
{
    const scalar invHSqr_;
    const scalar F_;
    const scalar W_;

public:
    WendlandC2(const dictionary&, const scalar h)
    :
        KernelShape(h, 2),
        invHSqr_(1/(h*h)),
        F_(-35*invHSqr_*invHSqr_/(4*pi)),
        W_(7*invHSqr_/(4*pi))
    {}

    template<bool needsW, class real>
    void evaluate(const real& rSqr, real& F, real& W) const
    {
        const real qSqr = max(invHSqr_*rSqr, real(1e-20));
        const real q = qSqr*invSqrt(qSqr);
        const real t = max(1.0 - 0.5*q, real(0));
        F = F_*t*t*t;
        if constexpr (needsW)
        {
            W = W_*t*t*t*t*(1.0 + 2.0*q);
        }
    }
};

static const Kernel::Add<WendlandC2> add
(
    "WendlandC2", "Wendland's C2 function of support 2h"
);

} // namespace
} // namespace sph
