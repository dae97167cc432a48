#include "dictionary/expression.H"
#include "primitives/error.H"

#include <algorithm>
#include <cmath>
#include <map>

namespace sph
{

namespace
{

using Unary = scalar (*)(scalar);
using Binary = scalar (*)(scalar, scalar);

const std::map<std::string, Unary>& unaryFunctions()
{
    static const std::map<std::string, Unary> functions
    {
        {"degToRad", [](scalar x) { return x*pi/180; }},
        {"radToDeg", [](scalar x) { return x*180/pi; }},
        {"sqrt", [](scalar x) { return std::sqrt(x); }},
        {"cbrt", [](scalar x) { return std::cbrt(x); }},
        {"sqr", [](scalar x) { return x*x; }},
        {"exp", [](scalar x) { return std::exp(x); }},
        {"log", [](scalar x) { return std::log(x); }},
        {"log10", [](scalar x) { return std::log10(x); }},
        {"sin", [](scalar x) { return std::sin(x); }},
        {"cos", [](scalar x) { return std::cos(x); }},
        {"tan", [](scalar x) { return std::tan(x); }},
        {"asin", [](scalar x) { return std::asin(x); }},
        {"acos", [](scalar x) { return std::acos(x); }},
        {"atan", [](scalar x) { return std::atan(x); }},
        {"sinh", [](scalar x) { return std::sinh(x); }},
        {"cosh", [](scalar x) { return std::cosh(x); }},
        {"tanh", [](scalar x) { return std::tanh(x); }},
        {"abs", [](scalar x) { return std::abs(x); }},
        {"floor", [](scalar x) { return std::floor(x); }},
        {"ceil", [](scalar x) { return std::ceil(x); }},
        {"round", [](scalar x) { return std::round(x); }},
        {"sign", [](scalar x) { return x < 0 ? -1.0 : 1.0; }},
        {"pos", [](scalar x) { return x >= 0 ? 1.0 : 0.0; }},
        {"neg", [](scalar x) { return x < 0 ? 1.0 : 0.0; }}
    };
    return functions;
}

const std::map<std::string, Binary>& binaryFunctions()
{
    static const std::map<std::string, Binary> functions
    {
        {"pow", [](scalar x, scalar y) { return std::pow(x, y); }},
        {"atan2", [](scalar y, scalar x) { return std::atan2(y, x); }},
        {"hypot", [](scalar x, scalar y) { return std::hypot(x, y); }},
        {"min", [](scalar x, scalar y) { return std::min(x, y); }},
        {"max", [](scalar x, scalar y) { return std::max(x, y); }}
    };
    return functions;
}

scalar magnitude(const ExpressionValue& a)
{
    return std::hypot(a.v[0], a.v[1], a.v[2]);
}

void requireNumbers
(
    const std::string& name,
    const std::vector<ExpressionValue>& arguments,
    const std::size_t count
)
{
    if (arguments.size() != count)
    {
        throw std::invalid_argument
        (
            name + "() takes " + std::to_string(count) + " argument"
          + (count == 1 ? "" : "s") + ", not "
          + std::to_string(arguments.size())
        );
    }
    for (const ExpressionValue& argument : arguments)
    {
        if (argument.isVector)
        {
            throw std::invalid_argument(name + "() takes numbers, no vectors");
        }
    }
}

[[noreturn]] void refuseUnknown(const std::string& name)
{
    wordList known{"pi", "mag", "vector"};
    for (const auto& function : unaryFunctions())
    {
        known.push_back(function.first);
    }
    for (const auto& function : binaryFunctions())
    {
        known.push_back(function.first);
    }
    const word meant = nearest(name, known);
    throw std::invalid_argument
    (
        "unknown function '" + name + "()'"
      + (meant.empty() ? "" : ", did you mean '" + meant + "()'?")
    );
}

} // namespace


ExpressionValue callFunction
(
    const std::string& name, const std::vector<ExpressionValue>& arguments
)
{
    if (name == "mag" && arguments.size() == 1)
    {
        return ExpressionValue::number(magnitude(arguments[0]));
    }
    if (name == "pi")
    {
        requireNumbers(name, arguments, 0);
        return ExpressionValue::number(pi);
    }
    if (name == "vector")
    {
        requireNumbers(name, arguments, 3);
        return
        {
            true, {arguments[0].v[0], arguments[1].v[0], arguments[2].v[0]}
        };
    }
    const auto unary = unaryFunctions().find(name);
    if (unary != unaryFunctions().end())
    {
        requireNumbers(name, arguments, 1);
        return ExpressionValue::number(unary->second(arguments[0].v[0]));
    }
    const auto binary = binaryFunctions().find(name);
    if (binary != binaryFunctions().end())
    {
        requireNumbers(name, arguments, 2);
        return ExpressionValue::number
        (
            binary->second(arguments[0].v[0], arguments[1].v[0])
        );
    }
    refuseUnknown(name);
}

} // namespace sph
