#include "boundaries/Motion.H"

#include <algorithm>

namespace sph
{

Motion::Motion(const dictionary& dict)
:
    velocity_(dict.getVector("velocity", dimVelocity)),
    start_(dict.getOrDefault("start", 0, dimTime, Range::nonNegative()))
{
    if (!any())
    {
        dict.fail("velocity", "A wall that moves needs a velocity");
    }
    if (dict.found("end") == dict.found("travel"))
    {
        dict.fail
        (
            dict.found("end") ? "travel" : "",
            "Either the end of the motion [s] or its travel [m] must be given"
        );
    }
    if (dict.found("travel"))
    {
        const scalar travel =
            dict.get("travel", dimLength, Range::positive());
        end_ = start_ + travel/velocity_.norm();
        return;
    }
    end_ = dict.get("end", dimTime);
    if (!(end_ > start_))
    {
        dict.fail("end", "The motion must end after its start");
    }
}

vector Motion::displacement(const scalar time) const
{
    return (std::clamp(time, start_, end_) - start_)*velocity_;
}

vector Motion::velocity(const scalar time) const
{
    const bool moving = any() && time >= start_ && time <= end_;
    return moving ? velocity_ : vector(vector::Zero());
}

} // namespace sph
