#include "advice/knownLimits.H"

#include <cmath>
#include <sstream>

namespace sph
{

std::vector<std::string> knownLimits(const CaseScene& scene)
{
    std::vector<std::string> limits;
    std::ostringstream text;
    const auto say = [&]
    {
        limits.push_back(text.str());
        text.str("");
    };
    if (scene.across() < 10)
    {
        text
            << "coarse: " << scene.across() << " particles across; with 6 a"
               " column ended 14 % too low";
        say();
    }
    if (scene.falls)
    {
        text
            << "falls: nothing holds the material from below; what falls lands"
               " with up to 22 %\n    too much room: #includeEtc"
               " \"caseDicts/impact/sphSchemes\" prevents it";
        say();
    }
    if (scene.kind == "column" && scene.aspect() > 10)
    {
        text
            << "tall: a column of a = 15 kept 9 % too much volume: #includeEtc"
               "\n    \"caseDicts/impact/sphSchemes\" prevents it";
        say();
    }
    if (scene.KFactor < 50)
    {
        text
            << "soft: K is " << scene.KFactor << " rho0 g H; below 50 the"
               " weight alone compresses the\n    material by more than 2 %";
        say();
    }
    if (scene.KFactor > 1e4)
    {
        text
            << "stiff: K is " << scene.KFactor << " rho0 g H; the pressures of"
               " the weight are lost in\n    the noise of the densities";
        say();
    }
    const scalar tilt = std::tan(scene.slope);
    if (scene.fast && tilt > scene.fast->mu)
    {
        text
            << "steep: tan(slope) = " << tilt << " is above mu2 = "
            << scene.fast->mu << ": it accelerates\n    without end, and"
               " outgrows any K";
        say();
    }
    if
    (
        scene.kind == "incline" && scene.slow
     && tilt > scene.slow->mu && tilt < 1.05*scene.slow->mu
    )
    {
        text
            << "slow flow: the slope is hardly steeper than mu_s = "
            << scene.slow->mu << "; mu(I) is\n    ill-posed there, and the"
               " speed was 10 % off";
        say();
    }
    if (scene.slow && scene.slow->mu < 0.1)
    {
        text
            << "little friction: mu_s = " << scene.slow->mu << "; with 0.01 the"
               " pressures were rough, 6 % of rho g H";
        say();
    }
    return limits;
}

} // namespace sph
