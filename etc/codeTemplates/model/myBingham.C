// Bingham plastic, regularised after Papanastasiou, J. Rheol. 31, 385 (1987):
//
//     s = 2 eta D,   eta = eta0 + tau0 [1 - exp(-gammaDot/gammaDotR)]/gammaDot
//
// eta tends to eta0 + tau0/gammaDotR at rest: with an explicit viscous force
// the time step is bound by it.
//
//     rheology  myBingham;
//     myBinghamCoeffs { eta0 0.1; tau0 20; gammaDotR 1; }

#include "rheology/GeneralisedNewtonian.H"

#include <cmath>

namespace sph
{
namespace
{

class myBingham : public GeneralisedNewtonian
{
    const scalar eta0_;         // plastic viscosity [Pa s]
    const scalar tau0_;         // yield stress [Pa]
    const scalar gammaDotR_;    // rate below which it is a stiff fluid [1/s]

    scalar eta(const scalar gammaDot) const
    {
        const scalar x = gammaDot/gammaDotR_;
        const scalar share = x > 1e-8 ? -std::expm1(-x)/x : 1;
        return eta0_ + tau0_/gammaDotR_*share;
    }

public:
    // Each entry with its meaning and a sample for -listEntries, dimensions and
    // range; errors name file and line
    myBingham(const dictionary& dict, const EquationOfState&)
    :
        eta0_
        (
            dict.get
            (
                {"eta0", "plastic viscosity", "0.1"},
                dimDynamicViscosity, Range::nonNegative()
            )
        ),
        tau0_
        (
            dict.get
            (
                {"tau0", "yield stress", "20"},
                dimPressure, Range::nonNegative()
            )
        ),
        gammaDotR_
        (
            dict.get
            (
                {"gammaDotR", "rate below which it is a stiff fluid", "1"},
                dimRate, Range::positive()
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
            particles.eta[i] = eta(particles.gammaDot[i]);
            setStress(particles, i);
        }
    }
};

static const Rheology::Add<myBingham> add
(
    "myBingham", "Bingham plastic, regularised after Papanastasiou"
);

} // namespace
} // namespace sph
