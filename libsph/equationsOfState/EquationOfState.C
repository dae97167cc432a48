#include "equationsOfState/EquationOfState.H"

#include <cmath>

namespace sph
{

static scalar bulkModulus
(
    const dictionary& dict, const scalar rho0, const scalar magG
)
{
    if (dict.found("K"))
    {
        return dict.get("K", dimPressure, Range::positive());
    }
    const scalar factor = dict.getOrDefault
    (
        "KFactor", 100, dimless, Range::positive()
    );
    const scalar H = dict.get("H", dimLength, Range::positive());
    if (!(magG > 0))
    {
        dict.fail
        (
            "H", "Without gravity the bulk modulus cannot be KFactor rho0 g H:"
            " give K [Pa] instead"
        );
    }
    return factor*rho0*magG*H;
}

EquationOfState::EquationOfState
(
    const dictionary& dict, const scalar rho0, const scalar magG
)
:
    rho0_(rho0),
    K_(bulkModulus(dict, rho0, magG)),
    c_(std::sqrt(K_/rho0))
{}

} // namespace sph
