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
            << "coarse: " << scene.across() << " particles across; below 10"
               " the run-out was seen to miss by more than a tenth";
        say();
    }
    if (scene.kind == "column" && scene.aspect() > 10)
    {
        text
            << "tall: a column of a = 15 kept 9 % too much volume;"
               " #includeEtc \"caseDicts/impact/sphSchemes\" in"
               " system/sphSchemes prevents it";
        say();
    }
    if (scene.KFactor < 50)
    {
        text
            << "soft: K is " << scene.KFactor << " rho0 g H; below 50 the"
               " weight alone compresses the material by more than 2 %";
        say();
    }
    const scalar tilt = std::tan(scene.slope);
    if (scene.fast && tilt > scene.fast->mu)
    {
        text
            << "steep: the slope has a friction of " << tilt << ", above mu2 = "
            << scene.fast->mu << ": it accelerates without end, and K must"
               " follow 100 rho0 U^2";
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
            << scene.slow->mu << "; mu(I) is ill-posed there, and the speed was"
               " seen to be 10 % off";
        say();
    }
    if (scene.slow && scene.slow->mu < 0.1)
    {
        text
            << "little friction: mu_s = " << scene.slow->mu << ": like a"
               " liquid, it does not come to rest within its endTime";
        say();
    }
    return limits;
}

} // namespace sph
