#include "dictionary/valueText.H"

#include "dictionary/token.H"

#include <algorithm>
#include <cctype>

namespace sph
{

std::string valueText(const scalar value)
{
    return numberText(value);
}

std::string valueText(const label value)
{
    return std::to_string(value);
}

std::string valueText(const bool value)
{
    return value ? "yes" : "no";
}

std::string valueText(const word& value)
{
    const auto isPlain = [](const unsigned char c)
    {
        return std::isalnum(c) || c == '_' || c == '.' || c == ':';
    };
    const bool plain =
        !value.empty() && std::isalpha(static_cast<unsigned char>(value[0]))
     && std::all_of(value.begin(), value.end(), isPlain);
    return plain ? value : quoted(value);
}

std::string valueText(const vector& value)
{
    return "(" + numberText(value.x()) + " " + numberText(value.y()) + " 0)";
}

std::string valueText(const dimensionSet& value)
{
    return value.str();
}

} // namespace sph
