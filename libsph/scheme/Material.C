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
    )
{
    for (const char* entry : {"equationOfState", "rheology"})
    {
        std::cout
            << "Selecting " << entry << ' ' << dict.get<word>(entry) << '\n';
    }
    std::cout
        << "Selecting turbulence "
        << dict.getOrDefault<word>("turbulence", "laminar") << '\n';
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
