#include "dictionary/dimensionSet.H"

#include "dictionary/token.H"

#include <cmath>

namespace sph
{

bool dimensionSet::operator==(const dimensionSet& other) const
{
    for (std::size_t i = 0; i < exponents.size(); ++i)
    {
        if (std::abs(exponents[i] - other.exponents[i]) > 1e-9)
        {
            return false;
        }
    }
    return true;
}

std::string dimensionSet::str() const
{
    std::string text;
    for (const scalar exponent : exponents)
    {
        text += (text.empty() ? "[" : " ") + numberText(exponent);
    }
    return text + "]";
}

} // namespace sph
