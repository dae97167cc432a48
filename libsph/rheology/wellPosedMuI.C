// mu(I) that is well posed down to rest (see WellPosedFriction), as a
// generalised Newtonian fluid:
//
//     eta = min(mu(I) P/gammaDot, etaMax),   I = d gammaDot/sqrt(P/rhos)
//
// It has no yield stress: a heap creeps until it is flat.
// Barker & Gray, J. Fluid Mech. 828, 5 (2017).
//
//     rheology  wellPosedMuI;
//     wellPosedMuICoeffs
//     {
//         mus 0.3819; mu2 0.6435; I0 0.279; muInf 0.05; alpha 1.9;
//         d 5e-4; rhos 2500;  etaMax 20;
//     }

#include "rheology/GeneralisedNewtonian.H"
#include "rheology/Grains.H"
#include "rheology/WellPosedFriction.H"

#include <cmath>

namespace sph
{
namespace
{

class wellPosedMuI : public GeneralisedNewtonian
{
    const WellPosedFriction law_;
    const Grains grains_;
    const scalar etaMax_;

public:
    wellPosedMuI(const dictionary& dict, const EquationOfState&)
    :
        law_(dict),
        grains_(dict),
        etaMax_
        (
            dict.get
            (
                {"etaMax", "greatest viscosity", "20"},
                dimDynamicViscosity, Range::positive()
            )
        )
    {}

    void correct
    (
        Particles& particles, const ParticleRange& range, scalar
    ) const override
    {
        for (label i = range.begin; i < range.end; ++i)
        {
            const scalar P = std::max(particles.p[i] + particles.q[i], 0.0);
            const scalar gammaDot = particles.gammaDot[i];
            const scalar I =
                P > 0 ? grains_.d*gammaDot/std::sqrt(P/grains_.rhos) : 0;
            const scalar tau = law_.mu(I)*P;
            particles.I[i] = I;
            particles.eta[i] =
                P == 0 ? 0
              : gammaDot == 0 || tau >= etaMax_*gammaDot ? etaMax_
              : tau/gammaDot;
            setStress(particles, i);
        }
    }

    std::optional<Friction> friction(const scalar I) const override
    {
        return law_.friction(I);
    }
};

static const Rheology::Add<wellPosedMuI> add
(
    "wellPosedMuI", "mu(I) of Barker & Gray, well posed down to rest; creeps"
);

} // namespace
} // namespace sph
