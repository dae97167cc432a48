// mu(I) that is well posed down to rest (see WellPosedFriction), with an
// elastic stress and the exact solution, at every step, of
//
//     tau = mu(I) P,   I = d gammaDot_p/sqrt(P/rhos),
//     gammaDot_p = (tau* - tau)/(G dt)
//
// Time steps are those of sound, but there is no yield stress: a heap creeps.
// Barker & Gray, J. Fluid Mech. 828, 5 (2017).
//
//     rheology  elastoViscoplasticWellPosedMuI;
//     elastoViscoplasticWellPosedMuICoeffs
//     {
//         mus 0.3819; mu2 0.6435; I0 0.279; muInf 0.05; alpha 1.9;
//         d 5e-4; rhos 2500; GByK 0.5;
//     }

#include "rheology/ElastoViscoplastic.H"
#include "rheology/WellPosedFriction.H"

#include <cmath>

namespace sph
{
namespace
{

class elastoViscoplasticWellPosedMuI : public ElastoViscoplastic
{
    const WellPosedFriction law_;

public:
    elastoViscoplasticWellPosedMuI
    (
        const dictionary& dict, const EquationOfState& eos
    )
    :
        ElastoViscoplastic(dict, eos),
        law_(dict)
    {}

    void correct
    (
        Particles& particles, const ParticleRange& range, const scalar deltaT
    ) const override
    {
        const scalar aBySqrtP = G()*deltaT/(d()*std::sqrt(rhos()));
        integrate
        (
            particles, range, deltaT,
            [=](const lanes& tauTrial, const lanes& P)
            {
                return lanes([&](const auto lane)
                {
                    const scalar tau = tauTrial[lane], Pi = P[lane];
                    return tau > small
                      ? Pi*law_.solve(aBySqrtP*std::sqrt(Pi), Pi, tau) : tau;
                });
            }
        );
    }

    std::optional<Friction> friction(const scalar I) const override
    {
        return law_.friction(I);
    }
};

static const Rheology::Add<elastoViscoplasticWellPosedMuI> add
(
    "elastoViscoplasticWellPosedMuI",
    "mu(I) of Barker & Gray with an elastic stress; creeps"
);

} // namespace
} // namespace sph
