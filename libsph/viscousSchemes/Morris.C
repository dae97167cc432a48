// Morris' operator, div(eta grad U), conserving linear momentum.
//
//     a += 1/rho_i sum V (eta_i + eta_j) F U_ij                         (15)
//
// Morris, Fox & Zhu, J. Comput. Phys. 136, 214 (1997); Eq. 15 of Salehizadeh &
// Shafiei, Granular Matter 21:32 (2019). It lacks grad eta.(grad U)^T.
//
//     viscousScheme  Morris;

#include "viscousSchemes/ViscousScheme.H"

namespace sph
{
namespace
{

class Morris : public ViscousScheme
{
    Particles& particles_;
    const PairWalk::Slot V_;
    const PairWalk::Slot U_;
    const PairWalk::Slot eta_;

public:
    Morris(const dictionary&, PairWalk& walk)
    :
        particles_(walk.particles()),
        V_(walk.neighbour("V")),
        U_(walk.neighbour("U")),
        eta_(walk.neighbour("eta"))
    {}

    void evaluate(const PairBlock& block) override
    {
        const label i = block.first;
        const vectorLanes Ui = load(particles_.U, i);
        const lanes etai = load(&particles_.eta[i]);
        vectorLanes sum{0, 0};
        for (label k = 0; k < block.n; ++k)
        {
            sum +=
                (
                    block.scalar(V_, k)*(etai + block.scalar(eta_, k))
                   *block.F(k)
                )*(Ui - block.vector(U_, k));
        }
        const lanes invRho = 1.0/load(&particles_.rho[i]);
        store(load(particles_.a, i) + invRho*sum, particles_.a, i);
    }
};

static const ViscousScheme::Add<Morris> add
(
    "Morris", "pairwise div(eta grad U), Eq. 15"
);

} // namespace
} // namespace sph
