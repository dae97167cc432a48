#include "equationsOfState/EquationOfState.H"

#include <cmath>

namespace sph
{

static bool readAdaptive(const dictionary& dict)
{
    const bool adaptive = dict.getOrDefault
    (
        {"adaptive", "K follows the scene, from its first value"}, false
    );
    if (adaptive && dict.found("K"))
    {
        dict.fail
        (
            "K", "adaptive yes: K follows the scene. Give KFactor and H, from"
            " which it starts, in place of K"
        );
    }
    if (adaptive && EquationOfState::readTension(dict))
    {
        dict.fail
        (
            "tension", "adaptive yes is for materials that bear no tension:"
            " K follows the greatest pressure, not the greatest tension"
        );
    }
    return adaptive;
}

// A material that follows must stay nearly incompressible and subsonic
static scalar readKFactor(const dictionary& dict, const bool adaptive)
{
    return
        dict.found({"K", "bulk modulus, in place of KFactor and H", "1e5"})
      ? 0
      : dict.getOrDefault
        (
            {"KFactor", "bulk modulus over rho0 |g| H"}, 100, dimless,
            adaptive ? Range{10} : Range::positive()
        );
}

static scalar bulkModulus
(
    const dictionary& dict, const scalar KFactor,
    const scalar rho0, const scalar magG
)
{
    if (dict.found("K"))
    {
        return dict.get("K", dimPressure, Range::positive());
    }
    const scalar H = dict.get
    (
        {"H", "height of the material, for the bulk modulus", "0.1"},
        dimLength, Range::positive()
    );
    if (!(magG > 0))
    {
        dict.fail
        (
            "H", "Without gravity the bulk modulus cannot be KFactor rho0 g H:"
            " give K [Pa] instead"
        );
    }
    return KFactor*rho0*magG*H;
}

EquationOfState::EquationOfState
(
    const dictionary& dict, const scalar rho0, const scalar magG
)
:
    rho0_(rho0),
    adaptive_(readAdaptive(dict)),
    KFactor_(readKFactor(dict, adaptive_))
{
    setK(bulkModulus(dict, KFactor_, rho0, magG));
}

bool EquationOfState::readTension(const dictionary& dict)
{
    return dict.getOrDefault
    (
        {"tension", "negative pressures are kept, as in a fluid"}, false
    );
}

void EquationOfState::setK(const scalar K)
{
    K_ = K;
    c_ = std::sqrt(K_/rho0_);
}

} // namespace sph
