// Morris' operator, div(eta grad U), conserving linear momentum.
//
//     a += 1/rho_i sum V (eta_i + eta_j) F U_ij                         (15)
//
// Morris, Fox & Zhu, J. Comput. Phys. 136, 214 (1997); Eq. 15 of Salehizadeh &
// Shafiei, Granular Matter 21:32 (2019). It lacks grad eta.(grad U)^T.
//
//     viscousScheme  Morris;

#include "viscousSchemes/SymmetricOperator.H"

namespace sph
{
namespace
{

class Morris : public SymmetricOperator<Morris>
{
public:
    Morris(const dictionary&, const Particles& particles)
    :
        SymmetricOperator(particles)
    {}

    template<class I, class J, class Pair, class real>
    vectorOf<real> force
    (
        const I& i, const J& j, const Pair& ij, const vectorOf<real>& U
    ) const
    {
        return ((i(of::eta) + j(of::eta))*ij.F)*U;
    }
};

static const ViscousScheme::Add<Morris> add
(
    "Morris", "pairwise div(eta grad U), Eq. 15"
);

} // namespace
} // namespace sph
