// Morris' operator with Schwaiger's correction, consistent at surfaces: 0 for
// constant eta and a linear velocity, whatever is missing of the support.
//
//     a += 1/rho_i { tr(Gamma^-1)/n [ sum 2 V eta_ij F U_ij
//                                   - 2 eta_i (N.grad) U_i ]
//                  + grad eta.(grad U)^T }
//     eta_ij = 2 eta_i eta_j/(eta_i + eta_j)
//
// The limit is div(2 eta D) for div U = 0. Eq. 18 of Salehizadeh & Shafiei,
// Granular Matter 21:32 (2019), with the pair sum that its bracket belongs to.
// It conserves no momentum, and a surface feels no shear that ends there: that
// a free surface bears no traction is what the pair sum alone imposes.
//
//     viscousScheme  SchwaigerMorris;

#include "pairs/PairLoop.H"
#include "viscousSchemes/Schwaiger.H"

namespace sph
{
namespace
{

class SchwaigerMorris : public PairSum<SchwaigerMorris, ViscousScheme>
{
public:
    SchwaigerMorris(const dictionary&, const Particles&)
    {}

    bool conservesMomentum() const override { return false; }
    bool needsExactGradU() const override { return true; }

    static constexpr auto reads = fields(of::V, of::U, of::eta);

    template<class real>
    struct Sum
    {
        vectorOf<real> flux;
        SupportSums<real> support;
    };

    template<class I, class J, class Pair, class real>
    void add(const I& i, const J& j, const Pair& ij, Sum<real>& sum) const
    {
        using namespace of;
        const real eta_ij = harmonicMean(i(eta), j(eta));
        sum.flux += (2.0*j(V)*eta_ij*ij.F)*(i(U) - j(U));
        sum.support.add(i, j, ij);
    }

    template<class At>
    void finish(const At& i, const Sum<lanes>& sum) const
    {
        using namespace of;
        const Support support(sum.support);
        const tensorLanes gradU = i(of::gradU);
        const vectorLanes surface = (2.0*i(eta))*(gradU & support.N());
        const vectorLanes force =
            support.factor()*(sum.flux - surface)
          + (transpose(gradU) & support.gradEta());
        i.set(a, i(a) + (1.0/i(rho))*force);
    }
};

static const ViscousScheme::Add<SchwaigerMorris> add
(
    "SchwaigerMorris", "div(2 eta D), pair by pair, consistent at surfaces"
);

} // namespace
} // namespace sph
