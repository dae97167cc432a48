#include "dictionary/Range.H"

#include "dictionary/token.H"

#include <cmath>

namespace sph
{

std::string Range::str() const
{
    const bool hasMin = std::isfinite(min);
    const bool hasMax = std::isfinite(max);
    const std::string lower =
        (minAllowed ? "at least " : "greater than ") + numberText(min);
    const std::string upper =
        (maxAllowed ? "at most " : "less than ") + numberText(max);

    if (hasMin && hasMax)
    {
        return minAllowed && maxAllowed
          ? "from " + numberText(min) + " to " + numberText(max)
          : lower + " and " + upper;
    }
    return hasMin ? lower : hasMax ? upper : "a finite number";
}

} // namespace sph
