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
    rho0_(readRho0(dict)),
    eos_
    (
        EquationOfState::New
        (
            dict, {"equationOfState", "pressure from density", "linear"},
            rho0_, g.norm()
        )
    ),
    rheology_
    (
        Rheology::New
        (
            dict,
            {
                "rheology", "law of the deviatoric stress",
                "elastoViscoplasticMuI"
            },
            *eos_
        )
    ),
    turbulence_
    (
        Turbulence::New
        (
            dict, {"turbulence", "sub-particle-scale stress"}, "laminar",
            spacing
        )
    ),
    sideWalls_
    (
        SideWalls::New
        (
            dict, {"sideWalls", "friction of the walls in front and behind"},
            "none"
        )
    )
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

scalar Material::readRho0(const dictionary& dict)
{
    return dict.get
    (
        {"rho0", "bulk density at rest", "1600"}, dimDensity, Range::positive()
    );
}

scalar Material::cP() const
{
    return eos_->c()*std::sqrt(1 + rheology_->G()/eos_->K());
}

} // namespace sph
