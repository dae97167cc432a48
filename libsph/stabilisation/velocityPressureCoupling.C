// The paper's coupling of velocity and pressure: the wide Laplacian of the
// pressure, which does not see pressure noise, against the compact one.
//
//     rhoDot = rho sigma dt ( <lap p>/rho - grad rho.grad p/rho^2
//                           - <div <grad p/rho>> )                 (31)-(32)
//     <lap p>_i = tr(L)/2 { sum 2 V F (p_i - p_j) - 2 grad p.sum V grad W }
//                                                                      (17)
//     grad p = c^2 grad rho
//
// over granular neighbours and where p > 0; L is that of the correction, over
// all neighbours, and c that at rho0. Salehizadeh & Shafiei, Granular Matter 21:32
// (2019), after Fatehi & Manzari, Int. J. Numer. Methods Fluids 68, 905
// (2012). It acts as deltaSPH with delta = sigma c dt/h. With the step as
// printed it fades where the viscous limit makes steps short; with dt = Co h/c
// instead it does not:
//
//     stabilisation  velocityPressureCoupling;
//     velocityPressureCouplingCoeffs
//     {
//         sigma      1;
//         timeScale  step;                // as printed
//     //  timeScale  acoustic;  Co 0.2;   // Co: as that of Eq. 33
//     }

#include "pairs/PairLoop.H"
#include "stabilisation/Stabilisation.H"

namespace sph
{
namespace
{

class velocityPressureCoupling
:
    public PairSum<velocityPressureCoupling, Stabilisation>
{
    const scalar sigma_;
    const bool acoustic_;
    const scalar CoH_;
    const EquationOfState& eos_;
    scalar deltaT_ = 0;

public:
    velocityPressureCoupling
    (
        const dictionary& dict, const EquationOfState& eos,
        const Kernel& kernel
    )
    :
        sigma_
        (
            dict.getOrDefault
            (
                {"sigma", "strength of the coupling, Eq. 32"}, 1,
                dimless, Range::nonNegative()
            )
        ),
        acoustic_
        (
            dict.getChoiceOrDefault
            (
                {"timeScale", "its time: the step, or Co h/c"}, "step",
                {"step", "acoustic"}
            )
         == "acoustic"
        ),
        CoH_
        (
            acoustic_
          ? kernel.h()*dict.getOrDefault
            (
                {"Co", "Courant number of that time"}, 0.2,
                dimless, Range::positive()
            )
          : 0
        ),
        eos_(eos)
    {}

    void setDeltaT(const scalar deltaT) override
    {
        deltaT_ = acoustic_ ? CoH_/eos_.c() : deltaT;
    }

    static constexpr auto reads = fields(of::Vg, of::p, of::rho, of::gradRho);

    template<class real>
    struct Sum
    {
        real wide;              // sum V (grad rho/rho)_j - ..._i . grad W
        real compact;           // sum 2 V F (p_i - p_j)
        vectorOf<real> N;       // sum V grad W
    };

    template<class I, class J, class Pair, class real>
    void add(const I& i, const J& j, const Pair& ij, Sum<real>& sum) const
    {
        using namespace of;
        const vectorOf<real> VgradW = j(Vg)*ij.gradW();
        sum.wide +=
            ((1.0/j(rho))*j(gradRho) - (1.0/i(rho))*i(gradRho)) & VgradW;
        sum.compact += 2.0*j(Vg)*ij.F*(i(p) - j(p));
        sum.N += VgradW;
    }

    template<class At, class real>
    void finish(const At& i, const Sum<real>& sum) const
    {
        using namespace of;
        const scalar cSqr = eos_.c()*eos_.c();
        const vectorOf<real> gradP = cSqr*i(gradRho);
        const real laplacian =
            0.5*(i(L).xx + i(L).yy)*(sum.compact - 2.0*(gradP & sum.N));
        const real rate =
            sigma_*deltaT_
           *(
                laplacian - (i(gradRho) & gradP)/i(rho)
              - cSqr*i(rho)*sum.wide
            );
        i.set(rhoDot, select(i(p) > 0.0, rate, real(0)));
    }
};

static const Stabilisation::Add<velocityPressureCoupling> add
(
    "velocityPressureCoupling", "the paper's coupling, Eqs. 31-32"
);

} // namespace
} // namespace sph
