// How each kind of token is read, once its first character is known.

#include "dictionary/tokeniser.H"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>

namespace sph
{

Token Tokeniser::string()
{
    Token token = start(Token::Kind::string);
    take();
    while (!atEnd() && ahead() != '"' && ahead() != '\n')
    {
        const char c = take();
        if (c == '\\' && ahead() == '\r' && ahead(1) == '\n')
        {
            take();
        }
        if (c == '\\' && (ahead() == '"' || ahead() == '\n'))
        {
            token.text += take();
        }
        else if (c == '\\' && ahead() == '\\')
        {
            token.text += c;
            token.text += take();
        }
        else
        {
            token.text += c;
        }
    }
    if (ahead() != '"')
    {
        fail
        (
            "The string opened here is not closed: \"" + token.text,
            token.line
        );
    }
    take();
    return token;
}

Token Tokeniser::verbatim()
{
    Token token = start(Token::Kind::verbatim);
    const std::size_t close = text_.find("#}", at_ + 2);
    if (close == std::string::npos)
    {
        fail("The text opened here by #{ is not closed by #}", token.line);
    }
    token.text = text_.substr(at_ + 2, close - at_ - 2);
    while (at_ < close + 2)
    {
        take();
    }
    return token;
}

Token Tokeniser::dimensions()
{
    Token token = start(Token::Kind::dimensions);
    take();
    while (!atEnd() && ahead() != ']')
    {
        if (std::strchr(";{}[\"", ahead()))
        {
            break;
        }
        token.text += take();
    }
    if (ahead() != ']')
    {
        fail("The '[' opened here is not closed by ']'", token.line);
    }
    take();
    return token;
}

Token Tokeniser::number()
{
    Token token = start(Token::Kind::number);
    while (ahead() && std::strchr("0123456789+-.eE", ahead()))
    {
        token.text += take();
    }
    const char* const end = token.text.data() + token.text.size();
    const char* const begin = token.text.data() + (token.text[0] == '+');
    const auto result = std::from_chars(begin, end, token.value);
    if (result.ptr != end || result.ec == std::errc::invalid_argument)
    {
        fail("'" + token.text + "' is not a number", token.line);
    }
    if (result.ec == std::errc::result_out_of_range)
    {
        // Of what is out of range only this says whether above or below
        token.value = std::strtod(token.text.c_str(), nullptr);
        if (!std::isfinite(token.value))
        {
            fail
            (
                "The number " + token.text + " is too large to be finite",
                token.line
            );
        }
    }
    token.isLabel = token.text.find_first_of(".eE") == std::string::npos;
    return token;
}

Token Tokeniser::variable()
{
    Token token = start(Token::Kind::variable);
    take();
    if (ahead() == '{')
    {
        label line = 0;
        bracedText(token.text, line);
    }
    else
    {
        token.text = wordText(true);
    }
    if (token.text.empty())
    {
        fail("A name is missing after '$'", token.line);
    }
    return token;
}

Token Tokeniser::word()
{
    Token token = start(Token::Kind::word);
    token.text = wordText(false);
    return token;
}

// Parentheses belong to a word as long as they are balanced: div(phi,U). None
// is looked for that closes so many, again and again from each of them
std::string Tokeniser::wordText(const bool slashes)
{
    constexpr label deepest = 50;
    const std::size_t begin = at_;
    std::size_t firstParenthesis = std::string::npos;
    label depth = 0;
    while
    (
        isWordCharacter(ahead())
     || (slashes && ahead() == '/' && !startsComment())
    )
    {
        if (ahead() == '(')
        {
            firstParenthesis = std::min(firstParenthesis, at_);
            if (++depth > deepest)
            {
                break;
            }
        }
        else if (ahead() == ')' && --depth < 0)
        {
            break;
        }
        take();
    }
    if (depth > 0)
    {
        at_ = firstParenthesis;
    }
    return text_.substr(begin, at_ - begin);
}

bool Tokeniser::bracedText(std::string& inside, label& line)
{
    skipBlanks();
    if (ahead() != '{')
    {
        return false;
    }
    line = line_;
    take();
    const std::size_t begin = at_;
    for (label depth = 1; ; )
    {
        if (atEnd())
        {
            fail("The '{' opened here is not closed by '}'", line);
        }
        if (startsComment())
        {
            skipComment();
            continue;
        }
        const char c = take();
        depth += (c == '{') - (c == '}');
        if (depth == 0)
        {
            inside = withoutComments(text_.substr(begin, at_ - 1 - begin));
            return true;
        }
    }
}

} // namespace sph
