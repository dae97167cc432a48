#include "scheme/Material.H"

#include <cmath>
#include <iostream>

namespace sph
{

Material::Material
(
    const dictionary& dict, const vector& g, const scalar spacing
)
:
    rho0_(dict.get("rho0", dimDensity, Range::positive())),
    eos_(EquationOfState::New(dict, "equationOfState", rho0_, g.norm())),
    rheology_(Rheology::New(dict, "rheology", *eos_)),
    turbulence_(Turbulence::New(dict, "turbulence", "laminar", spacing)),
    sideWalls_(SideWalls::New(dict, "sideWalls", "none"))
{
    for
    (
        const auto& [entry, missing] :
        {
            std::pair("equationOfState", ""), std::pair("rheology", ""),
            std::pair("turbulence", "laminar"), std::pair("sideWalls", "none")
        }
    )
    {
        std::cout << "Selecting " << entry << ' '
            << dict.getOrDefault<word>(entry, missing) << '\n';
    }
}

scalar Material::cP() const
{
    return eos_->c()*std::sqrt(1 + rheology_->G()/eos_->K());
}

} // namespace sph
