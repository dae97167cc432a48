#include "dictionary/units.H"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <map>
#include <sstream>
#include <stdexcept>

namespace sph
{

namespace
{

const std::map<std::string, Unit>& knownUnits()
{
    static const std::map<std::string, Unit> units
    {
        {"kg", {dimMass, 1}},
        {"g", {dimMass, 1e-3}},
        {"m", {dimLength, 1}},
        {"s", {dimTime, 1}},
        {"K", {{0, 0, 0, 1}, 1}},
        {"mol", {{0, 0, 0, 0, 1}, 1}},
        {"A", {{0, 0, 0, 0, 0, 1}, 1}},
        {"cd", {{0, 0, 0, 0, 0, 0, 1}, 1}},
        {"rad", {dimless, 1}},
        {"Hz", {dimRate, 1}},
        {"N", {{1, 1, -2}, 1}},
        {"Pa", {dimPressure, 1}},
        {"J", {{1, 2, -2}, 1}},
        {"W", {{1, 2, -3}, 1}},
        {"C", {{0, 0, 1, 0, 0, 1}, 1}},
        {"V", {{1, 2, -3, 0, 0, -1}, 1}}
    };
    return units;
}

const std::map<std::string, scalar>& prefixes()
{
    static const std::map<std::string, scalar> factors
    {
        {"P", 1e15}, {"T", 1e12}, {"G", 1e9}, {"M", 1e6}, {"k", 1e3},
        {"h", 1e2}, {"da", 1e1}, {"d", 1e-1}, {"c", 1e-2}, {"m", 1e-3},
        {"u", 1e-6}, {"n", 1e-9}, {"p", 1e-12}, {"f", 1e-15}
    };
    return factors;
}

Unit namedUnit(const std::string& name)
{
    const auto& units = knownUnits();
    if (const auto found = units.find(name); found != units.end())
    {
        return found->second;
    }
    for (const auto& [prefix, factor] : prefixes())
    {
        const auto found = name.compare(0, prefix.size(), prefix) == 0
          ? units.find(name.substr(prefix.size())) : units.end();
        if (found != units.end() && found->first != "kg")
        {
            return {found->second.dimensions, factor*found->second.factor};
        }
    }
    std::string message = "unknown unit '" + name + "'; the units are";
    for (const auto& unit : units)
    {
        message += ' ' + unit.first;
    }
    throw std::invalid_argument(message + ", with prefixes as in mm or kPa");
}

// Products and quotients of powers: kg m^-3, W/(m K)
class UnitParser
{
    std::string text_;
    std::size_t at_ = 0;

    char ahead()
    {
        while (at_ < text_.size() && std::isspace(text_[at_] & 0x7f))
        {
            ++at_;
        }
        return at_ < text_.size() ? text_[at_] : '\0';
    }

    [[noreturn]] void refuse() const
    {
        throw std::invalid_argument
        (
            "the dimensions [" + text_ + "] cannot be read"
        );
    }

    static Unit product(Unit a, const Unit& b, const scalar power)
    {
        for (std::size_t i = 0; i < a.dimensions.exponents.size(); ++i)
        {
            a.dimensions.exponents[i] += power*b.dimensions.exponents[i];
        }
        a.factor *= std::pow(b.factor, power);
        return a;
    }

    scalar exponent()
    {
        if (ahead() != '^')
        {
            return 1;
        }
        ++at_;
        const bool braced = ahead() == '(';
        at_ += braced;
        const char* const begin = text_.c_str() + at_;
        char* end = nullptr;
        const scalar value = std::strtod(begin, &end);
        at_ += end - begin;
        if (end == begin || !std::isfinite(value) || (braced && ahead() != ')'))
        {
            refuse();
        }
        at_ += braced;
        return value;
    }

    Unit factor()
    {
        Unit unit;
        if (ahead() == '(')
        {
            ++at_;
            unit = quotient();
            if (ahead() != ')')
            {
                refuse();
            }
            ++at_;
        }
        else if (ahead() == '1')
        {
            ++at_;
        }
        else
        {
            std::string name;
            while (std::isalpha(static_cast<unsigned char>(ahead())))
            {
                name += text_[at_++];
                if (at_ < text_.size() && std::isspace(text_[at_] & 0x7f))
                {
                    break;
                }
            }
            if (name.empty())
            {
                refuse();
            }
            unit = namedUnit(name);
        }
        return product({}, unit, exponent());
    }

    Unit quotient()
    {
        Unit unit = factor();
        while (ahead() && ahead() != ')')
        {
            const char sign = ahead();
            at_ += sign == '/' || sign == '*';
            unit = product(unit, factor(), sign == '/' ? -1 : 1);
        }
        return unit;
    }

public:
    explicit UnitParser(const std::string& text) : text_(text) {}

    Unit read()
    {
        const Unit unit = quotient();
        if (ahead())
        {
            refuse();
        }
        return unit;
    }
};

bool readExponents(const std::string& text, Unit& unit)
{
    std::istringstream is(text);
    std::vector<scalar> numbers;
    for (scalar number; is >> number; )
    {
        numbers.push_back(number);
    }
    const bool counted =
        numbers.empty() || numbers.size() == 5 || numbers.size() == 7;
    std::copy_n
    (
        numbers.begin(),
        counted ? numbers.size() : 0,
        unit.dimensions.exponents.begin()
    );
    is.clear();
    std::string rest;
    const bool onlyNumbers = !(is >> rest);
    if (onlyNumbers && !counted)
    {
        throw std::invalid_argument
        (
            "the dimensions [" + text + "] need 5 or 7 exponents, "
            "[kg m s K mol A cd]"
        );
    }
    return onlyNumbers;
}

} // namespace


Unit readUnit(const std::string& text)
{
    if (text.size() > 200)
    {
        throw std::invalid_argument("the dimensions are too long");
    }
    Unit unit;
    return readExponents(text, unit) ? unit : UnitParser(text).read();
}

} // namespace sph
