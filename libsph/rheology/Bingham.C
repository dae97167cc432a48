// Bingham plastic as a generalised Newtonian fluid, regularised:
//
//     tau = tau0 + eta gammaDot
//
// For one that stops below yield: elastoViscoplasticHerschelBulkley.
//
//     rheology  Bingham;
//     BinghamCoeffs
//     {
//         tau0 20;  eta 0.5;
//         regularisation Papanastasiou;  alphar 0.1;
//     //  regularisation cap;            etaMax 50;
//     }

#include "rheology/YieldStress.H"

namespace sph
{
namespace
{

class Bingham : public YieldStress
{
    const scalar eta_;

public:
    Bingham(const dictionary& dict, const EquationOfState&)
    :
        YieldStress(dict),
        eta_
        (
            dict.get
            (
                {"eta", "plastic viscosity", "0.5"},
                dimDynamicViscosity, Range::nonNegative()
            )
        )
    {}

    void correct
    (
        Particles& particles, const ParticleRange& range, scalar
    ) const override
    {
        setViscosity(particles, range, [=](scalar) { return eta_; });
    }
};

static const Rheology::Add<Bingham> add
(
    "Bingham", "yield stress and constant plastic viscosity, regularised"
);

} // namespace
} // namespace sph
