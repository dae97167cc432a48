// Cubic B-spline M4, support 2h.
//
//     W = 10/(7 pi h^2) { 1 - 3/2 q^2 + 3/4 q^3   q <= 1
//                       { 1/4 (2 - q)^3           q <= 2                 (10)
//
// Salehizadeh & Shafiei, Granular Matter 21:32 (2019), after Monaghan &
// Lattanzio, Astron. Astrophys. 149, 135 (1985).
//
//     kernel  cubicSpline;

#include "kernels/Kernel.H"

namespace sph
{
namespace
{

class cubicSpline : public Kernel
{
public:
    cubicSpline(const dictionary&, const scalar h)
    :
        Kernel(h, 2)
    {}

    void evaluate
    (
        const label n, const scalar* rSqr, scalar* F, scalar* W
    ) const override
    {
        const scalar sigma = 10/(7*pi);
        evaluateRows
        (
            n, rSqr, F, W,
            [=](const lanes& q, const lanes& invQ, lanes& f, lanes& w)
            {
                const lanes t = max(lanes(2) - q, lanes(0));
                const auto inner = q < 1;
                f = sigma*select
                (
                    inner, 2.25*q - 3, -0.75*t*t*invQ
                );
                w = sigma*select
                (
                    inner, 1 + q*q*(0.75*q - 1.5), 0.25*t*t*t
                );
            }
        );
    }
};

static const Kernel::Add<cubicSpline> add
(
    "cubicSpline", "M4 B-spline of support 2h, Eq. 10"
);

} // namespace
} // namespace sph
