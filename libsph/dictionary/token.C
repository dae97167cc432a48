#include "dictionary/token.H"

#include "dictionary/contents.H"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace sph
{

Token Token::word(const std::string& text, const label line)
{
    Token token;
    token.kind = Kind::word;
    token.text = text;
    token.line = line;
    return token;
}

Token Token::punctuation(const char c, const label line)
{
    Token token;
    token.kind = Kind::punctuation;
    token.text = c;
    token.line = line;
    return token;
}

Token Token::number(const scalar value, const label line)
{
    Token token;
    token.kind = Kind::number;
    token.text = numberText(value);
    token.line = line;
    token.value = value;
    token.isLabel = token.text.find_first_of(".eE") == std::string::npos;
    return token;
}

std::string Token::description() const
{
    switch (kind)
    {
        case Kind::word: return "word '" + text + "'";
        case Kind::string: return "string " + quoted(text);
        case Kind::verbatim: return "verbatim text";
        case Kind::number: return "number " + text;
        case Kind::dimensions: return "dimensions [" + text + "]";
        case Kind::punctuation: return "punctuation '" + text + "'";
        case Kind::variable: return "macro '$" + text + "'";
        case Kind::directive: return "directive '#" + text + "'";
        case Kind::block: return "a dictionary";
        case Kind::end: break;
    }
    return "the end of the text";
}

std::string numberText(const scalar value)
{
    char text[32];
    if (std::floor(value) == value && std::abs(value) < 1e15)
    {
        std::snprintf(text, sizeof(text), "%.0f", value == 0 ? 0.0 : value);
        return text;
    }
    for (int digits = 6; digits <= 17; ++digits)
    {
        std::snprintf(text, sizeof(text), "%.*g", digits, value);
        if (std::strtod(text, nullptr) == value)
        {
            break;
        }
    }
    return text;
}

std::string quoted(const std::string& text)
{
    std::string result = "\"";
    for (const char c : text)
    {
        if (c == '"' || c == '\n')
        {
            result += '\\';
        }
        result += c;
    }
    return result + '"';
}

std::string tokenText(const TokenList& tokens, const TokenStyle style)
{
    const bool typed = style == TokenStyle::asTyped;
    std::string result;
    for (const Token& token : tokens)
    {
        if (!result.empty())
        {
            result += ' ';
        }
        switch (token.kind)
        {
            case Token::Kind::string:
                result += quoted(token.text);
                break;
            case Token::Kind::verbatim:
                result += typed
                  ? "#{" + token.text + "#}" : quoted(token.text);
                break;
            case Token::Kind::number:
                result += typed ? token.text : numberText(token.value);
                break;
            case Token::Kind::dimensions:
                result += '[' + token.text + ']';
                break;
            case Token::Kind::block:
                result += dictionary::Contents::of(*token.block).inlineText
                (
                    style
                );
                break;
            default:
                result += token.text;
        }
    }
    return result;
}

} // namespace sph
