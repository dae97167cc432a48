#include "boundaries/Motion.H"

#include <algorithm>

namespace sph
{

Motion::Motion(const dictionary& dict)
:
    velocity_
    (
        dict.getVector
        (
            {"velocity", "velocity of the wall while it moves", "(0 1.3 0)"},
            dimVelocity
        )
    ),
    start_
    (
        dict.getOrDefault
        (
            {"start", "time at which it sets off"}, 0,
            dimTime, Range::nonNegative()
        )
    )
{
    if (!any())
    {
        dict.fail("velocity", "A wall that moves needs a velocity");
    }
    if (dict.found({"travel", "how far it goes, in place of end", "0.2"}))
    {
        if (dict.found("end"))
        {
            dict.fail
            (
                "travel", "Either the end of the motion [s] or its travel [m]"
                " must be given"
            );
        }
        const scalar travel =
            dict.get("travel", dimLength, Range::positive());
        end_ = start_ + travel/velocity_.norm();
        return;
    }
    end_ = dict.get
    (
        {"end", "time at which it stops; or travel, how far it goes", "0.15"},
        dimTime
    );
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
