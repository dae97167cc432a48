#include "dictionary/expression.H"

#include <cmath>

namespace sph
{

namespace
{

ExpressionValue scaled(ExpressionValue value, const scalar factor)
{
    for (scalar& component : value.v)
    {
        component *= factor;
    }
    return value;
}

// a + sign*b
ExpressionValue added
(
    ExpressionValue a, const ExpressionValue& b, const scalar sign
)
{
    if (a.isVector != b.isVector)
    {
        throw std::invalid_argument("a number and a vector cannot be added");
    }
    for (std::size_t i = 0; i < a.v.size(); ++i)
    {
        a.v[i] += sign*b.v[i];
    }
    return a;
}

ExpressionValue multiplied
(
    const ExpressionValue& a, const ExpressionValue& b
)
{
    if (a.isVector && b.isVector)
    {
        throw std::invalid_argument("two vectors cannot be multiplied");
    }
    return a.isVector ? scaled(a, b.v[0]) : scaled(b, a.v[0]);
}

// The unused components of a number stay 0 when it is divided by 0
ExpressionValue divided(ExpressionValue a, const ExpressionValue& b)
{
    if (b.isVector)
    {
        throw std::invalid_argument("nothing can be divided by a vector");
    }
    for (std::size_t i = 0; i < (a.isVector ? a.v.size() : 1); ++i)
    {
        a.v[i] /= b.v[0];
    }
    return a;
}

} // namespace


ExpressionValue applyOperator
(
    const char operation, const ExpressionValue& a, const ExpressionValue& b
)
{
    switch (operation)
    {
        case '+': return added(a, b, 1);
        case '-': return added(a, b, -1);
        case '*': return multiplied(a, b);
        case '/': return divided(a, b);
        default: break;
    }
    if (a.isVector || b.isVector)
    {
        throw std::invalid_argument("% takes numbers, no vectors");
    }
    return ExpressionValue::number(std::fmod(a.v[0], b.v[0]));
}

} // namespace sph
