// Quintic B-spline M6, support 3h: smoother, 2.25 times the neighbours of M4.
//
//     W = 7/(478 pi h^2) { (3-q)^5 - 6 (2-q)^5 + 15 (1-q)^5   q <= 1
//                        { (3-q)^5 - 6 (2-q)^5                q <= 2
//                        { (3-q)^5                            q <= 3
//
// Morris, Fox & Zhu, J. Comput. Phys. 136, 214 (1997).
//
//     kernel  quinticSpline;

#include "kernels/Kernel.H"

namespace sph
{
namespace
{

class quinticSpline : public KernelShape<quinticSpline>
{
    const scalar invHSqr_;
    const scalar F_;
    const scalar W_;

    template<class real>
    static real pow4(const real& t)
    {
        const real tSqr = t*t;
        return tSqr*tSqr;
    }

public:
    quinticSpline(const dictionary&, const scalar h)
    :
        KernelShape(h, 3),
        invHSqr_(1/(h*h)),
        F_(7*invHSqr_*invHSqr_/(478*pi)),
        W_(7*invHSqr_/(478*pi))
    {}

    template<bool needsW, class real>
    void evaluate(const real& rSqr, real& F, real& W) const
    {
        const real qSqr = max(invHSqr_*rSqr, real(1e-20));
        const real invQ = invSqrt(qSqr);
        const real q = qSqr*invQ;
        const real t3 = max(3.0 - q, real(0));
        const real t2 = max(2.0 - q, real(0));
        // q < 1: the derivative multiplied out, as it is divided by q
        F = F_*select
        (
            q < 1.0,
            qSqr*(120.0 - 50.0*q) - 120.0,
            (30.0*pow4(t2) - 5.0*pow4(t3))*invQ
        );
        if constexpr (needsW)
        {
            const real t1 = max(1.0 - q, real(0));
            W = W_*(pow4(t3)*t3 - 6.0*pow4(t2)*t2 + 15.0*pow4(t1)*t1);
        }
    }
};

static const Kernel::Add<quinticSpline> add
(
    "quinticSpline", "M6 B-spline of support 3h"
);

} // namespace
} // namespace sph
