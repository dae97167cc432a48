// The paper's coupling of velocity and pressure: the wide Laplacian of the
// pressure, which does not see pressure noise, against the compact one.
//
//     rhoDot = rho sigma dt ( <lap p>/rho - grad rho.grad p/rho^2
//                           - <div <grad p/rho>> )                 (31)-(32)
//     <lap p>_i = tr(L)/2 { sum 2 V F (p_i - p_j) - 2 grad p.sum V grad W }
//                                                                      (17)
//     grad p = c^2 grad rho
//
// over granular neighbours. Salehizadeh & Shafiei, Granular Matter 21:32
// (2019), after Fatehi & Manzari, Int. J. Numer. Methods Fluids 68, 905
// (2012). It fades with the time step.
//
//     stabilisation  velocityPressureCoupling;
//     velocityPressureCouplingCoeffs { sigma 1; }

#include "stabilisation/Stabilisation.H"

namespace sph
{
namespace
{

class velocityPressureCoupling : public Stabilisation
{
    Particles& particles_;
    const scalar sigma_;
    const scalar cSqr_;
    scalar deltaT_ = 0;
    const PairWalk::Slot Vg_;
    const PairWalk::Slot p_;
    const PairWalk::Slot rho_;
    const PairWalk::Slot gradRho_;

public:
    velocityPressureCoupling
    (
        const dictionary& dict, PairWalk& walk,
        const EquationOfState& eos, const Kernel&
    )
    :
        particles_(walk.particles()),
        sigma_(dict.getOrDefault("sigma", 1, dimless, Range::nonNegative())),
        cSqr_(eos.c()*eos.c()),
        Vg_(walk.neighbour("Vg")),
        p_(walk.neighbour("p")),
        rho_(walk.neighbour("rho")),
        gradRho_(walk.neighbour("gradRho"))
    {}

    void setDeltaT(const scalar deltaT) override { deltaT_ = deltaT; }

    void evaluate(const PairBlock& block) override
    {
        const label i = block.first;
        const lanes rho = load(&particles_.rho[i]);
        const lanes p = load(&particles_.p[i]);
        const vectorLanes gradRho = load(particles_.gradRho, i);
        const symmTensorLanes L = load(particles_.L, i);
        const vectorLanes gradPByRho = (cSqr_/rho)*gradRho;

        lanes wide = 0, compact = 0;
        vectorLanes N{0, 0};
        for (label k = 0; k < block.n; ++k)
        {
            const lanes V = block.scalar(Vg_, k);
            const vectorLanes VgradW = V*block.gradW(k);
            const vectorLanes Gj =
                (cSqr_/block.scalar(rho_, k))*block.vector(gradRho_, k);
            wide += (Gj - gradPByRho) & VgradW;
            compact += 2.0*V*block.F(k)*(p - block.scalar(p_, k));
            N += VgradW;
        }

        const lanes laplacian =
            0.5*(L.xx + L.yy)*(compact - 2.0*rho*(gradPByRho & N));
        const lanes rhoDot =
            sigma_*deltaT_
           *(laplacian - (gradRho & gradPByRho) - rho*wide);
        store
        (
            select(p > 0, rhoDot, lanes(0)), &particles_.rhoDot[i]
        );
    }
};

static const Stabilisation::Add<velocityPressureCoupling> add
(
    "velocityPressureCoupling", "the paper's coupling, Eqs. 31-32"
);

} // namespace
} // namespace sph
