// Hooke's law for the volume.
//
//     p = K (rho/rho0 - 1),   p >= 0                                      (7)
//
// Salehizadeh & Shafiei, Granular Matter 21:32 (2019). The material bears no
// tension; `tension yes` keeps negative pressures (a fluid, as in tests).
//
//     equationOfState  linear;
//     linearCoeffs { KFactor 100; H 0.1; adaptive no; tension no; }

#include "equationsOfState/EquationOfState.H"

#include <algorithm>
#include <limits>

namespace sph
{
namespace
{

class linear : public EquationOfState
{
    const scalar pMin_;

public:
    linear(const dictionary& dict, const scalar rho0, const scalar magG)
    :
        EquationOfState(dict, rho0, magG),
        pMin_
        (
            readTension(dict) ? -std::numeric_limits<scalar>::max() : 0
        )
    {}

    scalar pressure(const scalar rho) const override
    {
        return std::max(pMin_, K()*(rho/rho0() - 1));
    }

    scalar density(const scalar p) const override
    {
        return rho0()*(1 + p/K());
    }

    void correct
    (
        const ParticleRange& range, const scalarField& rho, scalarField& p
    ) const override
    {
        const scalar K = this->K(), slope = K/rho0(), pMin = pMin_;
        #pragma omp simd
        for (label i = range.begin; i < range.end; ++i)
        {
            p[i] = std::max(pMin, slope*rho[i] - K);
        }
    }
};

static const EquationOfState::Add<linear> add
(
    "linear", "p = K (rho/rho0 - 1), Eq. 7"
);

} // namespace
} // namespace sph
