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

class quinticSpline : public Kernel
{
    static lanes pow4(const lanes& t)
    {
        const lanes tSqr = t*t;
        return tSqr*tSqr;
    }

public:
    quinticSpline(const dictionary&, const scalar h)
    :
        Kernel(h, 3)
    {}

    void evaluate
    (
        const label n, const scalar* rSqr, scalar* F, scalar* W
    ) const override
    {
        const scalar sigma = 7/(478*pi);
        evaluateRows
        (
            n, rSqr, F, W,
            [=](const lanes& q, const lanes& invQ, lanes& f, lanes& w)
            {
                const lanes t3 = max(3 - q, lanes(0));
                const lanes t2 = max(2 - q, lanes(0));
                const lanes t1 = max(1 - q, lanes(0));
                // q < 1: the derivative multiplied out, as it is divided by q
                f = sigma*select
                (
                    q < 1,
                    q*q*(120 - 50*q) - 120,
                    (30*pow4(t2) - 5*pow4(t3))*invQ
                );
                w = sigma*(pow4(t3)*t3 - 6*pow4(t2)*t2 + 15*pow4(t1)*t1);
            }
        );
    }
};

static const Kernel::Add<quinticSpline> add
(
    "quinticSpline", "M6 B-spline of support 3h"
);

} // namespace
} // namespace sph
