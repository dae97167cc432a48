// delta-SPH: diffuses what is left of the density difference of a pair when
// its linear part is taken out, so that a hydrostatic column stays as it is.
//
//     rhoDot = 2 delta h c sum V [ (rho_i - rho_j)
//                                 - 1/2 (grad rho_i + grad rho_j).r_ij ] F
//
// over granular neighbours. Antuono, Colagrossi & Marrone, Comput. Phys.
// Commun. 183, 2570 (2012).
//
//     stabilisation  deltaSPH;
//     deltaSPHCoeffs { delta 0.1; }

#include "stabilisation/Stabilisation.H"

namespace sph
{
namespace
{

class deltaSPH : public Stabilisation
{
    Particles& particles_;
    const scalar D_;            // 2 delta h c [m2/s]
    const PairWalk::Slot Vg_;
    const PairWalk::Slot rho_;
    const PairWalk::Slot gradRho_;

public:
    deltaSPH
    (
        const dictionary& dict, PairWalk& walk,
        const EquationOfState& eos, const Kernel& kernel
    )
    :
        particles_(walk.particles()),
        D_
        (
            2*dict.getOrDefault("delta", 0.1, dimless, Range::nonNegative())
           *kernel.h()*eos.c()
        ),
        Vg_(walk.neighbour("Vg")),
        rho_(walk.neighbour("rho")),
        gradRho_(walk.neighbour("gradRho"))
    {}

    void evaluate(const PairBlock& block) override
    {
        const label i = block.first;
        const lanes rho = load(&particles_.rho[i]);
        const vectorLanes gradRho = load(particles_.gradRho, i);
        lanes sum = 0;
        for (label k = 0; k < block.n; ++k)
        {
            const lanes linear =
                (gradRho + block.vector(gradRho_, k)) & block.r(k);
            sum +=
                block.scalar(Vg_, k)*block.F(k)
               *(rho - block.scalar(rho_, k) - 0.5*linear);
        }
        store(D_*sum, &particles_.rhoDot[i]);
    }
};

static const Stabilisation::Add<deltaSPH> add
(
    "deltaSPH", "density diffusion of Antuono et al."
);

} // namespace
} // namespace sph
