// Cleary's operator with Schwaiger's correction, consistent at surfaces: 0 for
// constant eta and a linear velocity, whatever is missing of the support.
//
//     a += 1/rho_i tr(Gamma^-1)/n
//          { sum 8 V eta_ij U_ij.r_ij/(r^2 + 0.01 dx^2) grad W
//          - 8 eta_i T:grad U }
//     T_kmi  = sum V F r_k r_m r_i/(r^2 + 0.01 dx^2)
//     eta_ij = 2 eta_i eta_j/(eta_i + eta_j)
//
// The limit is div(2 eta D) for div U = 0, with Cleary's share of it on an
// ordered lattice. Eq. 18 of Salehizadeh & Shafiei, Granular Matter 21:32
// (2019), with the bracket that its pair sum belongs to. On momentum and free
// surfaces see SchwaigerMorris.
//
//     viscousScheme  SchwaigerCleary;

#include "pairs/PairLoop.H"
#include "viscousSchemes/Schwaiger.H"

namespace sph
{
namespace
{

class SchwaigerCleary : public PairSum<SchwaigerCleary, ViscousScheme>
{
    const scalar guard_;

public:
    SchwaigerCleary(const dictionary&, const Particles& particles)
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
        real Txxx, Txxy, Txyy, Tyyy;
        SupportSums<real> support;
    };

    template<class I, class J, class Pair, class real>
    void add(const I& i, const J& j, const Pair& ij, Sum<real>& sum) const
    {
        using namespace of;
        const vectorOf<real> e =
            (j(V)/((ij.r & ij.r) + guard_))*ij.gradW();
        const real eta_ij = harmonicMean(i(eta), j(eta));
        sum.flux += (8.0*eta_ij*((i(U) - j(U)) & ij.r))*e;
        sum.Txxx += e.x*ij.r.x*ij.r.x;
        sum.Txxy += e.x*ij.r.x*ij.r.y;
        sum.Txyy += e.x*ij.r.y*ij.r.y;
        sum.Tyyy += e.y*ij.r.y*ij.r.y;
        sum.support.add(i, j, ij);
    }

    template<class At>
    void finish(const At& i, const Sum<lanes>& sum) const
    {
        using namespace of;
        const Support support(sum.support);
        const tensorLanes gradU = i(of::gradU);
        const lanes twoDxy = gradU.xy + gradU.yx;
        const vectorLanes surface
        {
            sum.Txxx*gradU.xx + sum.Txxy*twoDxy + sum.Txyy*gradU.yy,
            sum.Txxy*gradU.xx + sum.Txyy*twoDxy + sum.Tyyy*gradU.yy
        };
        const vectorLanes force =
            support.factor()*(sum.flux - (8.0*i(eta))*surface);
        i.set(a, i(a) + (1.0/i(rho))*force);
    }
};

static const ViscousScheme::Add<SchwaigerCleary> add
(
    "SchwaigerCleary", "div(2 eta D) along pairs, consistent at surfaces"
);

} // namespace
} // namespace sph
