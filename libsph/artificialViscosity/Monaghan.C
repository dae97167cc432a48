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

namespace sph
{
namespace
{

class Monaghan : public ArtificialViscosity
{
    Particles& particles_;
    const scalar alphaCh_;      // alpha c h/rho0 [m5/kg/s]
    const scalar guard_;        // 0.01 h^2 [m2]
    const PairWalk::Slot m_;
    const PairWalk::Slot U_;

public:
    Monaghan
    (
        const dictionary& dict, PairWalk& walk,
        const EquationOfState& eos, const Kernel& kernel
    )
    :
        particles_(walk.particles()),
        alphaCh_
        (
            dict.getOrDefault("alpha", 0.1, dimless, Range::nonNegative())
           *eos.c()*kernel.h()/eos.rho0()
        ),
        guard_(0.01*kernel.h()*kernel.h()),
        m_(walk.neighbour("m")),
        U_(walk.neighbour("U"))
    {}

    void evaluate(const PairBlock& block) override
    {
        const label i = block.first;
        const vectorLanes Ui = load(particles_.U, i);
        vectorLanes sum{0, 0};
        for (label k = 0; k < block.n; ++k)
        {
            const lanes approach =
                min((Ui - block.vector(U_, k)) & block.r(k), lanes(0));
            sum +=
                (block.scalar(m_, k)*approach/(block.rSqr(k) + guard_))
               *block.gradW(k);
        }
        store(load(particles_.a, i) + lanes(alphaCh_)*sum, particles_.a, i);
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
