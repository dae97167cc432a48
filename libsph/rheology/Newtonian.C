// Newtonian fluid: s = 2 eta D.
//
//     rheology  Newtonian;
//     NewtonianCoeffs { eta [1 -1 -1 0 0 0 0] 1e-3; }

#include "rheology/GeneralisedNewtonian.H"

namespace sph
{
namespace
{

class Newtonian : public GeneralisedNewtonian
{
    const scalar eta_;

public:
    Newtonian(const dictionary& dict, const EquationOfState&)
    :
        eta_
        (
            dict.get
            (
                {"eta", "viscosity", "1"},
                dimDynamicViscosity, Range::nonNegative()
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
            particles.eta[i] = eta_;
            setStress(particles, i);
        }
    }
};

static const Rheology::Add<Newtonian> add
(
    "Newtonian", "s = 2 eta D with constant eta"
);

} // namespace
} // namespace sph
