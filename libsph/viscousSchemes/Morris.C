// Morris' operator, div(eta grad U), conserving linear momentum.
//
//     a += 1/rho_i sum V (eta_i + eta_j) F U_ij                         (15)
//
// Morris, Fox & Zhu, J. Comput. Phys. 136, 214 (1997); Eq. 15 of Salehizadeh &
// Shafiei, Granular Matter 21:32 (2019). It lacks grad eta.(grad U)^T.
//
//     viscousScheme  Morris;

#include "pairs/PairLoop.H"
#include "viscousSchemes/ViscousScheme.H"

namespace sph
{
namespace
{

class Morris : public PairSum<Morris, ViscousScheme>
{
public:
    Morris(const dictionary&, const Particles&)
    {}

    static constexpr auto reads = fields(of::V, of::U, of::eta);

    template<class real>
    using Sum = vectorOf<real>;

    template<class I, class J, class Pair, class real>
    void add
    (
        const I& i, const J& j, const Pair& ij, vectorOf<real>& sum
    ) const
    {
        using namespace of;
        sum += (j(V)*(i(eta) + j(eta))*ij.F)*(i(U) - j(U));
    }

    template<class At, class real>
    void finish(const At& i, const vectorOf<real>& sum) const
    {
        i.set(of::a, i(of::a) + (1.0/i(of::rho))*sum);
    }
};

static const ViscousScheme::Add<Morris> add
(
    "Morris", "pairwise div(eta grad U), Eq. 15"
);

} // namespace
} // namespace sph
