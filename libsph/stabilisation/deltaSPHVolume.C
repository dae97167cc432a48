// delta-SPH that keeps the volume of a material sheared without end.
//
// rho is the time integral of the divergence. Corrected gradients make that
// exact for linear motion, but of particles that rattle past each other it
// keeps a small mean, and after a shear of order 100 a layer has lost several
// percent of its volume at unchanged rho. Where the support is complete, rho
// returns to the sum over the particles, at the pace of the shear:
//
//     rhoDot = deltaSPH + beta gammaDot (sum m W - rho),   lambda > lambdaMin
//
// What rests is left alone.
//
//     stabilisation  deltaSPHVolume;
//     deltaSPHVolumeCoeffs { delta 0.1; beta 0.1; lambdaMin 0.9; }

#include "pairs/PairLoop.H"
#include "stabilisation/Stabilisation.H"

namespace sph
{
namespace
{

class deltaSPHVolume : public PairSum<deltaSPHVolume, Stabilisation>
{
    const EquationOfState& eos_;
    const scalar twoDeltaH_;
    const scalar beta_;
    const scalar lambdaMin_;
    const scalar W0_;

public:
    deltaSPHVolume
    (
        const dictionary& dict, const EquationOfState& eos,
        const Kernel& kernel
    )
    :
        eos_(eos),
        twoDeltaH_
        (
            2*kernel.h()*dict.getOrDefault
            (
                {"delta", "strength of the density diffusion"}, 0.1,
                dimless, Range::nonNegative()
            )
        ),
        beta_
        (
            dict.getOrDefault
            (
                {"beta", "pace of the return to the summed density"}, 0.1,
                dimless, Range::nonNegative()
            )
        ),
        lambdaMin_
        (
            dict.getOrDefault
            (
                {"lambdaMin", "lambda above which rho returns"}, 0.9,
                dimless, Range::between(0, 1)
            )
        ),
        W0_(kernel.W(0))
    {}

    static constexpr bool needsW = true;
    static constexpr auto reads =
        fields(of::Vg, of::rho, of::gradRho, of::m);

    template<class real>
    struct Sum
    {
        real diffusion;
        real rho;
    };

    template<class I, class J, class Pair, class real>
    void add(const I& i, const J& j, const Pair& ij, Sum<real>& sum) const
    {
        using namespace of;
        const real linear = (i(gradRho) + j(gradRho)) & ij.r;
        sum.diffusion += j(Vg)*ij.F*(i(rho) - j(rho) - 0.5*linear);
        sum.rho += j(m)*ij.W;
    }

    template<class At, class real>
    void finish(const At& i, const Sum<real>& sum) const
    {
        using namespace of;
        const real pace = select
        (
            i(lambda) > lambdaMin_, beta_*i(gammaDot), real(0)
        );
        i.set
        (
            rhoDot,
            (twoDeltaH_*eos_.c())*sum.diffusion
          + pace*(sum.rho + W0_*i(m) - i(rho))
        );
    }
};

static const Stabilisation::Add<deltaSPHVolume> add
(
    "deltaSPHVolume", "deltaSPH, and the volume of flows without end kept"
);

} // namespace
} // namespace sph
