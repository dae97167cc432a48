// Drucker-Prager plasticity without dilation: mu(I) in the limit of slow flow.
//
//     tau = min(tau*, mus P)
//
// Drucker & Prager, Q. Appl. Math. 10, 157 (1952).
//
//     rheology  DruckerPrager;
//     DruckerPragerCoeffs { mus 0.3819; d 5e-4; rhos 2500; GByK 0.5; }

#include "rheology/ElastoViscoplastic.H"

namespace sph
{
namespace
{

class DruckerPrager : public ElastoViscoplastic
{
    const scalar mus_;

public:
    DruckerPrager(const dictionary& dict, const EquationOfState& eos)
    :
        ElastoViscoplastic(dict, eos),
        mus_
        (
            dict.get
            (
                {"mus", "friction coefficient", "0.3819"},
                dimless, Range::nonNegative()
            )
        )
    {}

    void correct
    (
        Particles& particles, const ParticleRange& range, const scalar deltaT
    ) const override
    {
        integrate
        (
            particles, range, deltaT,
            [=](const lanes& tauTrial, const lanes& P)
            {
                return min(tauTrial, mus_*P);
            }
        );
    }

    std::optional<Friction> friction(scalar) const override
    {
        return Friction{mus_, 0};
    }
};

static const Rheology::Add<DruckerPrager> add
(
    "DruckerPrager", "rate-independent friction, no dilation"
);

} // namespace
} // namespace sph
