// Cleary's operator, div(2 eta D), conserving angular momentum.
//
//     a += 1/rho_i sum 8 V 2 eta_i eta_j/(eta_i + eta_j)
//                     U_ij.r_ij/(r^2 + 0.01 dx^2) grad W                 (16)
//
// Cleary & Monaghan, J. Comput. Phys. 148, 227 (1999); Eq. 16 of Salehizadeh &
// Shafiei, Granular Matter 21:32 (2019). On an ordered lattice its shear part
// is 0.87 of the limit at h = 1.3 dx.
//
//     viscousScheme  Cleary;

#include "viscousSchemes/harmonicMean.H"
#include "viscousSchemes/SymmetricOperator.H"

namespace sph
{
namespace
{

class Cleary : public SymmetricOperator<Cleary>
{
    const scalar guard_;

public:
    Cleary(const dictionary&, const Particles& particles)
    :
        SymmetricOperator(particles),
        guard_(0.01*particles.spacing()*particles.spacing())
    {}

    template<class I, class J, class Pair, class real>
    vectorOf<real> force
    (
        const I& i, const J& j, const Pair& ij, const vectorOf<real>& U
    ) const
    {
        using namespace of;
        const real approach = (U & ij.r)/((ij.r & ij.r) + guard_);
        return (8.0*harmonicMean(i(eta), j(eta))*approach)*ij.gradW();
    }
};

static const ViscousScheme::Add<Cleary> add
(
    "Cleary", "pairwise div(2 eta D), Eq. 16"
);

} // namespace
} // namespace sph
