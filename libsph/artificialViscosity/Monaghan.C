// Monaghan's artificial viscosity, between approaching particles.
//
//     a -= sum m Pi grad W,   Pi = -alpha c mu/rho0   where U_ij.r_ij < 0,
//     mu = h U_ij.r_ij/(r^2 + 0.01 h^2)
//
// Monaghan, Rep. Prog. Phys. 68, 1703 (2005). It acts on shear as well: use
// gradientCorrected for granular flow.
//
//     artificialViscosity  Monaghan;
//     MonaghanCoeffs { alpha 0.1; }

#include "artificialViscosity/ArtificialViscosity.H"
#include "pairs/PairLoop.H"

namespace sph
{
namespace
{

class Monaghan : public PairSum<Monaghan, ArtificialViscosity>
{
    const scalar alpha_;
    const scalar h_;
    const EquationOfState& eos_;

public:
    Monaghan
    (
        const dictionary& dict, const EquationOfState& eos,
        const Kernel& kernel
    )
    :
        alpha_
        (
            dict.getOrDefault
            (
                {"alpha", "strength"}, 0.1, dimless, Range::nonNegative()
            )
        ),
        h_(kernel.h()),
        eos_(eos)
    {}

    static constexpr auto reads = fields(of::m, of::U);

    template<class real>
    using Sum = vectorOf<real>;

    template<class I, class J, class Pair, class real>
    void add
    (
        const I& i, const J& j, const Pair& ij, vectorOf<real>& sum
    ) const
    {
        using namespace of;
        const real approach = min((i(U) - j(U)) & ij.r, real(0));
        const real mu = h_*approach/((ij.r & ij.r) + 0.01*h_*h_);
        sum += j(m)*mu*ij.gradW();
    }

    template<class At, class real>
    void finish(const At& i, const vectorOf<real>& sum) const
    {
        const scalar f = alpha_*eos_.c()/eos_.rho0();
        i.set(of::a, i(of::a) + f*sum);
    }

    void bulkPressure
    (
        Particles& particles, const ParticleRange& range
    ) const override
    {
        noBulkPressure(particles, range);
    }
};

static const ArtificialViscosity::Add<Monaghan> add
(
    "Monaghan", "Monaghan's viscosity between approaching particles"
);

} // namespace
} // namespace sph
