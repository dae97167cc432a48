// The length of a step, and the time that it leads to.
#include "runTime/TimeData.H"

#include "runTime/log.H"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace sph
{

namespace
{

constexpr scalar growth = 1.2;

constexpr scalar manySteps = 2e7;

} // namespace


bool sameTime(const scalar a, const scalar b)
{
    return std::abs(a - b) <= 1e-12*std::max(std::abs(a), std::abs(b));
}

std::string timeText(const scalar value)
{
    std::ostringstream os;
    os << value;
    return os.str();
}

bool Time::Data::atEnd() const
{
    // To half a step where steps are fixed, to rounding where they are not
    if (!controls.adjustTimeStep)
    {
        return !(state.value < controls.endTime - 0.5*controls.deltaT);
    }
    return
        !(state.value < controls.endTime)
     || sameTime(state.value, controls.endTime);
}

scalar Time::Data::limitedDeltaT(const scalar stable) const
{
    const scalar limit = controls.grownDeltaT(stable);
    if (state.deltaTLimit > 0)
    {
        return std::min(limit, growth*state.deltaTLimit);
    }
    return controls.deltaT > 0 ? std::min(limit, controls.deltaT) : limit;
}

scalar Time::Data::nextTarget() const
{
    if (controls.writeControl != TimeControls::WriteControl::adjustable)
    {
        return controls.endTime;
    }
    const scalar next = scalar(writeIndex + 1)*controls.writeInterval;
    return
        next < controls.endTime || sameTime(next, controls.endTime)
      ? next : controls.endTime;
}

scalar Time::Data::stopTime() const
{
    switch (controls.stopAt)
    {
        case TimeControls::StopAt::endTime:
            return controls.endTime;
        case TimeControls::StopAt::nextWrite:
            return
                controls.writesBySimulatedTime()
              ? scalar(writeIndex + 1)*controls.writeInterval
              : std::numeric_limits<scalar>::infinity();
        default:
            return state.value;
    }
}

scalar Time::Data::shortenedDeltaT(const scalar limit) const
{
    const scalar remaining = nextTarget() - state.value;
    if (!(remaining > 0) || (std::isinf(remaining) && !std::isinf(limit)))
    {
        return limit;
    }

    // A step may be longer than its limit by rounding
    return remaining/std::max(1.0, std::ceil(remaining/limit - 1e-9));
}

void Time::Data::warnOfManySteps(const scalar stable)
{
    const scalar deltaT = controls.grownDeltaT(stable);
    const scalar steps = (controls.endTime - state.value)/deltaT;
    if (warnedOfManySteps || !std::isfinite(steps) || steps < manySteps)
    {
        return;
    }
    warnedOfManySteps = true;
    warning
    (
        "Steps of " + timeText(deltaT) + " s: it takes " + timeText(steps)
      + " of them to endTime.\n    A lower bulk modulus (KFactor) or viscosity"
        " (etaMax, alphar) allows longer steps"
    );
}

void Time::Data::checkFixedDeltaT(const scalar stable) const
{
    if (controls.deltaT <= stable)
    {
        return;
    }
    // Two digits, rounded down
    const scalar unit = std::pow(10, std::floor(std::log10(stable)) - 1);
    controlDict().fail
    (
        "deltaT",
        "deltaT " + timeText(controls.deltaT) + " s is above the stable limit "
      + timeText(stable) + " s at time " + name
      + " s\n\nUse adjustTimeStep yes, or deltaT <= "
      + timeText(unit*std::floor(stable/unit))
    );
}

scalar Time::Data::steppedValue() const
{
    const scalar value = state.value + state.deltaT;
    const auto near = [&](const scalar other)
    {
        return std::abs(value - other) <= 1e-6*state.deltaT;
    };
    if (controls.writesBySimulatedTime())
    {
        const scalar interval = controls.writeInterval;
        const scalar writeTime = std::round(value/interval)*interval;
        if (near(writeTime))
        {
            return writeTime;
        }
    }
    return near(controls.endTime) ? controls.endTime : value;
}

std::int64_t Time::Data::presentWriteIndex() const
{
    using Control = TimeControls::WriteControl;
    const auto intervals = [&](const scalar t)
    {
        const scalar n = t/controls.writeInterval;
        const scalar nearest = std::round(n);
        return std::int64_t
        (
            sameTime(n, nearest) ? nearest : std::floor(n)
        );
    };
    switch (controls.writeControl)
    {
        case Control::timeStep:
            return state.index/std::int64_t(controls.writeInterval);
        case Control::clockTime:
            return intervals(clockTime());
        case Control::cpuTime:
            return intervals(cpuTime());
        default:
            // The step nearest to the write time where none can hit it
            return intervals
            (
                state.value
              + (controls.hitsWriteTimes() ? 0 : 0.5*state.deltaT)
            );
    }
}

} // namespace sph
