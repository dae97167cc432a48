#include "dictionary/expression.H"

#include "dictionary/expressionText.H"

#include <cctype>
#include <cmath>
#include <cstring>

namespace sph
{

namespace
{

using Value = ExpressionValue;
using VariableValue = std::function<Value(const std::string&)>;

// Recursive descent, one function a level of precedence
class Evaluator
{
    ExpressionText text_;
    const VariableValue& variable_;
    const std::map<std::string, scalar>& names_;
    label depth_ = 0;

    scalar number(const Value& value) const
    {
        if (value.isVector)
        {
            text_.fail("a number is needed here, not a vector");
        }
        return value.v[0];
    }

    Value combine(const char operation, const Value& a, const Value& b) const
    {
        try
        {
            return applyOperator(operation, a, b);
        }
        catch (const std::invalid_argument& error)
        {
            text_.fail(error.what());
        }
    }

    Value choice()
    {
        if (++depth_ > 200)
        {
            text_.fail("the expression is nested too deeply");
        }
        Value value = disjunction();
        if (text_.take("?"))
        {
            const bool chosen = number(value) != 0;
            const Value yes = choice();
            text_.expect(":", "of the choice");
            const Value no = choice();
            value = chosen ? yes : no;
        }
        --depth_;
        return value;
    }

    Value disjunction()
    {
        Value a = conjunction();
        while (text_.take("||"))
        {
            const Value b = conjunction();
            a = Value::number(number(a) != 0 || number(b) != 0);
        }
        return a;
    }

    Value conjunction()
    {
        Value a = equality();
        while (text_.take("&&"))
        {
            const Value b = equality();
            a = Value::number(number(a) != 0 && number(b) != 0);
        }
        return a;
    }

    Value equality()
    {
        Value a = comparison();
        while (true)
        {
            const bool equal = text_.take("==");
            if (!equal && !text_.take("!="))
            {
                return a;
            }
            const Value b = comparison();
            const bool same = a.isVector == b.isVector && a.v == b.v;
            a = Value::number(same == equal);
        }
    }

    Value comparison()
    {
        Value a = sum();
        while (text_.ahead() == '<' || text_.ahead() == '>')
        {
            const bool less = text_.takeChar() == '<';
            const bool orEqual = text_.take("=");
            const scalar left = number(a);
            const scalar right = number(sum());
            a = Value::number
            (
                (orEqual && left == right)
             || (less ? left < right : left > right)
            );
        }
        return a;
    }

    Value sum()
    {
        Value a = product();
        while (text_.ahead() == '+' || text_.ahead() == '-')
        {
            const char operation = text_.takeChar();
            a = combine(operation, a, product());
        }
        return a;
    }

    Value product()
    {
        Value a = unary();
        while (text_.ahead() && std::strchr("*/%", text_.ahead()))
        {
            const char operation = text_.takeChar();
            a = combine(operation, a, unary());
        }
        return a;
    }

    Value unary()
    {
        if (++depth_ > 200)
        {
            text_.fail("the expression is nested too deeply");
        }
        Value value;
        if (text_.take("-"))
        {
            value = combine('*', unary(), Value::number(-1));
        }
        else if (text_.take("!"))
        {
            value = Value::number(number(unary()) == 0);
        }
        else
        {
            text_.take("+");
            value = operand();
        }
        --depth_;
        return value;
    }

    Value operand()
    {
        const char c = text_.ahead();
        if (text_.take("("))
        {
            const Value value = choice();
            text_.expect(")", "that closes a '('");
            return value;
        }
        if (std::isdigit(static_cast<unsigned char>(c)) || c == '.')
        {
            return Value::number(text_.number());
        }
        if (c == '$')
        {
            return variable();
        }
        if (std::isalpha(static_cast<unsigned char>(c)))
        {
            return named();
        }
        text_.failOperand();
    }

    Value variable()
    {
        const std::size_t begin = text_.position();
        const std::string name = text_.variable();
        if (name.empty())
        {
            text_.fail("a name is missing after '$'", begin);
        }
        try
        {
            return variable_(name);
        }
        catch (const std::invalid_argument& error)
        {
            text_.fail(error.what(), begin);
        }
    }

    Value named()
    {
        const std::size_t begin = text_.position();
        const std::string name = text_.name();
        if (name == "true" || name == "false")
        {
            return Value::number(name == "true");
        }
        const auto known = names_.find(name);
        if (known != names_.end())
        {
            return Value::number(known->second);
        }
        if (!text_.take("("))
        {
            text_.fail
            (
                "unknown name '" + name + "': write $" + name
              + " for an entry, " + name + "() for a function",
                begin
            );
        }
        std::vector<Value> arguments;
        while (!text_.take(")"))
        {
            if (!arguments.empty())
            {
                text_.expect(",", "or ')' between the arguments of " + name);
            }
            arguments.push_back(choice());
        }
        try
        {
            return callFunction(name, arguments);
        }
        catch (const std::invalid_argument& error)
        {
            text_.fail(error.what(), begin);
        }
    }

public:
    Evaluator
    (
        const std::string& text, const VariableValue& variable,
        const std::map<std::string, scalar>& names
    )
    :
        text_(text),
        variable_(variable),
        names_(names)
    {}

    Value result()
    {
        const Value value = choice();
        if (const char c = text_.ahead())
        {
            text_.fail("unexpected '" + std::string(1, c) + "'");
        }
        for (const scalar component : value.v)
        {
            if (!std::isfinite(component))
            {
                text_.fail("the result is not a finite number");
            }
        }
        return value;
    }
};

} // namespace


ExpressionValue evaluate
(
    const std::string& text, const VariableValue& variable,
    const std::map<std::string, scalar>& names
)
{
    return Evaluator(text, variable, names).result();
}

} // namespace sph
