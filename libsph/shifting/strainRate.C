// Shifting in proportion to the shear rate: what is at rest stays where it is.
//
//     Us = -A h^2 gammaDot sum V [1 + 0.2 (W/W(dx))^4] grad W
//
// where the support is complete, lambda > lambdaMin. After Xu, Stansby &
// Laurence, J. Comput. Phys. 228, 6703 (2009), and Lind et al., J. Comput.
// Phys. 231, 1499 (2012); the pairing term is theirs.
//
//     shifting  strainRate;
//     strainRateCoeffs { A 1; lambdaMin 0.75; }

#include "shifting/Shifting.H"

namespace sph
{
namespace
{

class strainRate : public Shifting
{
    Particles& particles_;
    const scalar AhSqr_;
    const scalar lambdaMin_;
    const scalar invWdx_;
    const PairWalk::Slot V_;

public:
    strainRate(const dictionary& dict, PairWalk& walk, const Kernel& kernel)
    :
        particles_(walk.particles()),
        AhSqr_
        (
            dict.getOrDefault("A", 1, dimless, Range::nonNegative())
           *kernel.h()*kernel.h()
        ),
        lambdaMin_
        (
            dict.getOrDefault("lambdaMin", 0.75, dimless, Range::between(0, 1))
        ),
        invWdx_(1/kernel.W(walk.particles().spacing())),
        V_(walk.neighbour("V"))
    {
        walk.needsW();
    }

    void evaluate(const PairBlock& block) override
    {
        const label i = block.first;
        vectorLanes sum{0, 0};
        for (label k = 0; k < block.n; ++k)
        {
            const lanes W2 = block.W(k)*invWdx_*(block.W(k)*invWdx_);
            sum +=
                (block.scalar(V_, k)*(1.0 + 0.2*W2*W2))*block.gradW(k);
        }
        const lanes rate = select
        (
            load(&particles_.lambda[i]) > lambdaMin_,
            -AhSqr_*load(&particles_.gammaDot[i]), lanes(0)
        );
        store(rate*sum, particles_.Us, i);
    }
};

static const Shifting::Add<strainRate> add
(
    "strainRate", "shifting in proportion to the shear rate"
);

} // namespace
} // namespace sph
