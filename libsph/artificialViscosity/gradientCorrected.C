// Sub-grid viscosity that a linear velocity field does not feel, and a bulk
// viscous pressure.
//
//     a += sum m nu/rho0 2 F [ U_ij - 1/2 (grad U_i + grad U_j).r_ij ],
//          nu = alpha c h/8
//     q  = -chi rho0 c h div U,  within +-p/2,  0 where p = 0
//
// The resolved, linear part of the velocity is subtracted, so that shear flow
// is not damped. q belongs to the pressure that yield sees. The explicit step
// stays stable for chi maxCo <= 0.5.
//
//     artificialViscosity  gradientCorrected;
//     gradientCorrectedCoeffs { alpha 0.3; chi 1; }

#include "artificialViscosity/ArtificialViscosity.H"

namespace sph
{
namespace
{

class gradientCorrected : public ArtificialViscosity
{
    Particles& particles_;
    const scalar shear_;        // 2 nu/rho0 [m5/kg/s]
    const scalar bulk_;         // chi rho0 c h [Pa s]
    const PairWalk::Slot m_;
    const PairWalk::Slot U_;
    const PairWalk::Slot gradU_;

public:
    gradientCorrected
    (
        const dictionary& dict, PairWalk& walk,
        const EquationOfState& eos, const Kernel& kernel
    )
    :
        particles_(walk.particles()),
        shear_
        (
            dict.getOrDefault("alpha", 0.3, dimless, Range::nonNegative())
           *eos.c()*kernel.h()/(4*eos.rho0())
        ),
        bulk_
        (
            dict.getOrDefault("chi", 1, dimless, Range::nonNegative())
           *eos.rho0()*eos.c()*kernel.h()
        ),
        m_(walk.neighbour("m")),
        U_(walk.neighbour("U")),
        gradU_(walk.neighbour("gradU"))
    {}

    void evaluate(const PairBlock& block) override
    {
        const label i = block.first;
        const vectorLanes Ui = load(particles_.U, i);
        const tensorLanes gradUi = load(particles_.gradU, i);
        vectorLanes sum{0, 0};
        for (label k = 0; k < block.n; ++k)
        {
            const vectorLanes linear =
                (gradUi + block.tensor(gradU_, k)) & block.r(k);
            const vectorLanes Uij = Ui - block.vector(U_, k);
            sum +=
                (block.scalar(m_, k)*block.F(k))*(Uij - lanes(0.5)*linear);
        }
        store(load(particles_.a, i) + lanes(shear_)*sum, particles_.a, i);
    }

    void bulkPressure
    (
        Particles& particles, const ParticleRange& range
    ) const override
    {
        const scalar* div = particles.div.data();
        const scalar* p = particles.p.data();
        scalar* q = particles.q.data();
        const scalar bulk = bulk_;
        #pragma omp parallel for simd schedule(static)
        for (label i = range.begin; i < range.end; ++i)
        {
            const scalar limit = std::max(0.5*p[i], 0.0);
            q[i] = std::min(std::max(-bulk*div[i], -limit), limit);
        }
    }
};

static const ArtificialViscosity::Add<gradientCorrected> add
(
    "gradientCorrected", "sub-grid viscosity without the linear part of U"
);

} // namespace
} // namespace sph
