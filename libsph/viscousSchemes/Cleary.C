// Cleary's operator, div(2 eta D), conserving angular momentum.
//
//     a += 1/rho_i sum 8 V 2 eta_i eta_j/(eta_i + eta_j)
//                     U_ij.r_ij/(r^2 + 0.01 h^2) grad W                  (16)
//
// Cleary & Monaghan, J. Comput. Phys. 148, 227 (1999); Eq. 16 of Salehizadeh &
// Shafiei, Granular Matter 21:32 (2019). On an ordered lattice its shear part
// is 0.87 of the limit at h = 1.3 dx.
//
//     viscousScheme  Cleary;

#include "viscousSchemes/ViscousScheme.H"

namespace sph
{
namespace
{

class Cleary : public ViscousScheme
{
    Particles& particles_;
    const PairWalk::Slot V_;
    const PairWalk::Slot U_;
    const PairWalk::Slot eta_;
    const scalar guard_;

public:
    Cleary(const dictionary&, PairWalk& walk)
    :
        particles_(walk.particles()),
        V_(walk.neighbour("V")),
        U_(walk.neighbour("U")),
        eta_(walk.neighbour("eta")),
        guard_(0.01*walk.particles().spacing()*walk.particles().spacing())
    {}

    void evaluate(const PairBlock& block) override
    {
        const label i = block.first;
        const vectorLanes Ui = load(particles_.U, i);
        const lanes etai = load(&particles_.eta[i]);
        vectorLanes sum{0, 0};
        for (label k = 0; k < block.n; ++k)
        {
            const lanes etaj = block.scalar(eta_, k);
            const lanes harmonic =
                2.0*etai*etaj/max(etai + etaj, lanes(1e-30));
            const lanes approach =
                ((Ui - block.vector(U_, k)) & block.r(k))
               /(block.rSqr(k) + guard_);
            sum +=
                (8.0*block.scalar(V_, k)*harmonic*approach)*block.gradW(k);
        }
        const lanes invRho = 1.0/load(&particles_.rho[i]);
        store(load(particles_.a, i) + invRho*sum, particles_.a, i);
    }
};

static const ViscousScheme::Add<Cleary> add
(
    "Cleary", "pairwise div(2 eta D), Eq. 16"
);

} // namespace
} // namespace sph
