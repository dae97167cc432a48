#include "dictionary/expressionValue.H"

#include "dictionary/switchWord.H"
#include "dictionary/units.H"

#include <algorithm>

namespace sph
{

ExpressionValue expressionValue(const std::string& name, TokenList tokens)
{
    const std::string text = tokenText(tokens);
    scalar factor = 1;
    if (tokens.size() > 1 && tokens[0].kind == Token::Kind::word)
    {
        tokens.erase(tokens.begin());
    }
    if (tokens.size() > 1 && tokens[0].kind == Token::Kind::dimensions)
    {
        factor = readUnit(tokens[0].text).factor;
        tokens.erase(tokens.begin());
    }

    const auto isNumber = [](const Token& token)
    {
        return token.kind == Token::Kind::number;
    };
    if (tokens.size() == 1 && isNumber(tokens[0]))
    {
        return ExpressionValue::number(factor*tokens[0].value);
    }
    if (tokens.size() == 1 && switchValue(tokens[0]))
    {
        return ExpressionValue::number(*switchValue(tokens[0]));
    }
    const bool isVector =
        tokens.size() == 5 && tokens[0].is('(') && tokens[4].is(')')
     && std::all_of(tokens.begin() + 1, tokens.begin() + 4, isNumber);
    if (!isVector)
    {
        throw std::invalid_argument
        (
            "'$" + name + "' is neither a number nor a vector but '"
          + text + "'"
        );
    }
    return
    {
        true,
        {
            factor*tokens[1].value,
            factor*tokens[2].value,
            factor*tokens[3].value
        }
    };
}

} // namespace sph
