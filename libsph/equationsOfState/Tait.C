// Tait's equation: stiffens with compression.
//
//     p = K/gamma [(rho/rho0)^gamma - 1],   p >= 0
//
// Monaghan, J. Comput. Phys. 110, 399 (1994), with K = rho0 c^2.
//
//     equationOfState  Tait;
//     TaitCoeffs { KFactor 100; H 0.1; adaptive no; gamma 7; tension no; }

#include "equationsOfState/EquationOfState.H"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sph
{
namespace
{

class Tait : public EquationOfState
{
    const scalar gamma_;
    const scalar pMin_;

public:
    Tait(const dictionary& dict, const scalar rho0, const scalar magG)
    :
        EquationOfState(dict, rho0, magG),
        gamma_
        (
            dict.getOrDefault
            (
                {"gamma", "exponent: how fast it stiffens"}, 7,
                dimless, Range::between(1, 20)
            )
        ),
        pMin_
        (
            readTension(dict) ? -std::numeric_limits<scalar>::max() : 0
        )
    {}

    scalar pressure(const scalar rho) const override
    {
        return std::max
        (
            pMin_, K()/gamma_*(std::pow(rho/rho0(), gamma_) - 1)
        );
    }

    scalar density(const scalar p) const override
    {
        return rho0()*std::pow(1 + gamma_*p/K(), 1/gamma_);
    }

    void correct
    (
        const ParticleRange& range, const scalarField& rho, scalarField& p
    ) const override
    {
        for (label i = range.begin; i < range.end; ++i)
        {
            p[i] = pressure(rho[i]);
        }
    }
};

static const EquationOfState::Add<Tait> add
(
    "Tait", "p = K/gamma ((rho/rho0)^gamma - 1), stiffens with compression"
);

} // namespace
} // namespace sph
