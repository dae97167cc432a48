// Schwaiger's viscous operator as the paper prints it. INCONSISTENT AT
// SURFACES: its bracket cancels the surface error of the sum of Eq. 15, not of
// the one that stands before it. A uniform shear feels a force that grows like
// 1/dx in the surface row. Take SchwaigerMorris or SchwaigerCleary.
//
//     a += 1/rho_i tr(Gamma^-1)/n
//          { sum 8 V eta_ij U_ij.r_ij/(r^2 + 0.01 dx^2) grad W
//          - [grad(eta U) - U grad eta + eta grad U]_i.N }         (18), (20)
//     eta_ij = 2 eta_i eta_j/(eta_i + eta_j)
//
// Salehizadeh & Shafiei, Granular Matter 21:32 (2019).
//
//     viscousScheme  SchwaigerAsPrinted;

#include "pairs/PairLoop.H"
#include "viscousSchemes/Schwaiger.H"

namespace sph
{
namespace
{

class SchwaigerAsPrinted : public PairSum<SchwaigerAsPrinted, ViscousScheme>
{
    const scalar guard_;

public:
    SchwaigerAsPrinted(const dictionary&, const Particles& particles)
    :
        guard_(0.01*particles.spacing()*particles.spacing())
    {}

    bool conservesMomentum() const override { return false; }
    bool needsExactGradU() const override { return true; }

    static constexpr auto reads = fields(of::V, of::U, of::eta);

    template<class real>
    struct Sum
    {
        vectorOf<real> flux;
        tensorOf<real> gradEtaU;    // without Gamma^-1
        SupportSums<real> support;
    };

    template<class I, class J, class Pair, class real>
    void add(const I& i, const J& j, const Pair& ij, Sum<real>& sum) const
    {
        using namespace of;
        const vectorOf<real> VgradW = j(V)*ij.gradW();
        const real eta_ij = harmonicMean(i(eta), j(eta));
        const real approach =
            ((i(U) - j(U)) & ij.r)/((ij.r & ij.r) + guard_);
        sum.flux += (8.0*eta_ij*approach)*VgradW;
        sum.gradEtaU += outer(j(eta)*j(U) - i(eta)*i(U), VgradW);
        sum.support.add(i, j, ij);
    }

    template<class At>
    void finish(const At& i, const Sum<lanes>& sum) const
    {
        using namespace of;
        const Support support(sum.support);
        const tensorLanes bracket =
            (sum.gradEtaU & support.inverse())
          + (lanes(-1)*outer(i(U), support.gradEta()) + i(eta)*i(gradU));
        const vectorLanes force =
            support.factor()*(sum.flux - (bracket & support.N()));
        i.set(a, i(a) + (1.0/i(rho))*force);
    }
};

static const ViscousScheme::Add<SchwaigerAsPrinted> add
(
    "SchwaigerAsPrinted", "Eqs. 18, 20 as printed: INCONSISTENT AT SURFACES"
);

} // namespace
} // namespace sph
