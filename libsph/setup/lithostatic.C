#include "setup/lithostatic.H"

#include "rheology/Rheology.H"
#include "runTime/log.H"

#include <cmath>
#include <iostream>

namespace sph
{

vector readSurfaceNormal(const dictionary& dict, const vector& g)
{
    const vector up = dict.getVectorOrDefault
    (
        {"surfaceNormal", "out of the surface; else up", "(0 1 0)"},
        vector(-g.normalized()), dimless
    );
    if (!(up.dot(g) < 0))
    {
        dict.fail
        (
            "surfaceNormal",
            "The normal of the free surface must point against gravity"
        );
    }
    return up.normalized();
}

static bool lithostatic(const dictionary& dict)
{
    return dict.getChoiceOrDefault
    (
        {"stress", "what the material is loaded with at the start"},
        "hydrostatic", {"hydrostatic", "lithostatic"}
    ) == "lithostatic";
}

static scalar readK0(const dictionary& dict)
{
    return dict.getOrDefault
    (
        {"K0", "horizontal over vertical stress"}, 1,
        dimless, Range::between(0, 10)
    );
}

scalar pressureByStress(const dictionary& dict)
{
    return lithostatic(dict) ? (1 + readK0(dict))/2 : 1;
}

static void checkLaw
(
    const dictionary& dict, const dictionary& properties,
    const EquationOfState& equationOfState, const scalar tauByP
)
{
    const auto rheology =
        Rheology::New(properties, "rheology", equationOfState);
    if (!rheology->elastic())
    {
        dict.fail
        (
            "stress", "Rheology " + properties.get<word>("rheology")
          + " does not carry its stress: only elastic laws start with one"
        );
    }
    const auto friction = rheology->friction(0);
    if (friction && tauByP > friction->mu)
    {
        warning
        (
            "The lithostatic stress has a friction of "
          + std::to_string(tauByP) + ", but the material bears "
          + std::to_string(friction->mu) + " at rest: it yields at once"
        );
    }
}

void setLithostatic
(
    const dictionary& dict, const vector& g, const dictionary& properties,
    const EquationOfState& equationOfState, Particles& particles
)
{
    if (!lithostatic(dict))
    {
        return;
    }
    if (g.norm() == 0 || !dict.getOrDefault("hydrostatic", true))
    {
        dict.fail("stress", "A lithostatic stress needs hydrostatic yes"
            " and gravity");
    }
    const scalar K0 = readK0(dict), byP = 2/(1 + K0);
    const vector n = readSurfaceNormal(dict, g), t(n.y(), -n.x());
    const scalar normal = -(1 - K0)/2, shear = -g.dot(t)/g.dot(n);
    checkLaw
    (
        dict, properties, equationOfState, byP*std::hypot(normal, shear)
    );

    const tensor s =
        normal*(n*n.transpose() - t*t.transpose())
      + shear*(t*n.transpose() + n*t.transpose());
    for (label i = 0; i < particles.granular().end; ++i)
    {
        particles.s.set(i, byP*equationOfState.pressure(particles.rho[i])*s);
    }
    std::cout << "Lithostatic stress, K0 " << K0 << '\n';
}

} // namespace sph
