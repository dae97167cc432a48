#include "dictionary/tokeniser.H"

#include "primitives/error.H"

#include <cctype>
#include <cstring>

namespace sph
{

namespace
{

bool isSpace(const char c)
{
    return std::isspace(static_cast<unsigned char>(c));
}

bool isDigit(const char c)
{
    return c >= '0' && c <= '9';
}

bool isPunctuation(const char c)
{
    return c && std::strchr(";(){}],:=+-*/'", c);
}

} // namespace


bool isWordCharacter(const char c)
{
    return c && !isSpace(c) && !std::strchr("\"'/;{}", c);
}

Tokeniser::Tokeniser
(
    std::string text, std::string file, const label firstLine
)
:
    text_(std::move(text)),
    file_(std::move(file)),
    line_(firstLine)
{}

void Tokeniser::fail(const std::string& message, const label line) const
{
    throw IOError(message, file_, line);
}

char Tokeniser::take()
{
    const char c = text_[at_++];
    line_ += c == '\n';
    return c;
}

bool Tokeniser::startsComment() const
{
    return ahead() == '/' && (ahead(1) == '/' || ahead(1) == '*');
}

bool Tokeniser::startsNumber() const
{
    const bool sign = ahead() == '-' || ahead() == '+';
    return isDigit(ahead(sign))
     || (ahead(sign) == '.' && isDigit(ahead(sign + 1)));
}

void Tokeniser::skipComment()
{
    const label opened = line_;
    const bool toLineEnd = ahead(1) == '/';
    take();
    take();
    while (!atEnd())
    {
        if (toLineEnd && ahead() == '\n')
        {
            return;
        }
        if (!toLineEnd && ahead() == '*' && ahead(1) == '/')
        {
            take();
            take();
            return;
        }
        take();
    }
    if (!toLineEnd)
    {
        fail("The comment opened here by /* is not closed by */", opened);
    }
}

// A byte order mark is none of the text, wherever files were put together
void Tokeniser::skipBlanks()
{
    while (!atEnd())
    {
        if (isSpace(ahead()))
        {
            take();
        }
        else if (startsComment())
        {
            skipComment();
        }
        else if (text_.compare(at_, 3, "\xEF\xBB\xBF") == 0)
        {
            at_ += 3;
        }
        else
        {
            return;
        }
    }
}

Token Tokeniser::start(const Token::Kind kind) const
{
    Token token;
    token.kind = kind;
    token.line = line_;
    return token;
}

const Token& Tokeniser::peek()
{
    if (putBack_.empty())
    {
        putBack_.push_back(next());
    }
    return putBack_.back();
}

Token Tokeniser::next()
{
    if (!putBack_.empty())
    {
        const Token token = putBack_.back();
        putBack_.pop_back();
        return token;
    }

    skipBlanks();
    if (atEnd())
    {
        return start(Token::Kind::end);
    }
    const char c = ahead();
    if (startsNumber())
    {
        return number();
    }
    if (c == '#' && ahead(1) == '{')
    {
        return verbatim();
    }
    if (c == '#' && isWordCharacter(ahead(1)))
    {
        Token token = start(Token::Kind::directive);
        take();
        while (std::isalnum(static_cast<unsigned char>(ahead())))
        {
            token.text += take();
        }
        return token;
    }
    switch (c)
    {
        case '"': return string();
        case '[': return dimensions();
        case '$': return variable();
        default: break;
    }
    if (isPunctuation(c))
    {
        const label line = line_;
        return Token::punctuation(take(), line);
    }
    if (!isWordCharacter(c))
    {
        fail("The text holds a character that cannot be read", line_);
    }
    return word();
}

std::string withoutComments(const std::string& text)
{
    std::string result = text;
    for (std::size_t i = 0; i + 1 < result.size(); ++i)
    {
        const bool block = result.compare(i, 2, "/*") == 0;
        if (!block && result.compare(i, 2, "//") != 0)
        {
            continue;
        }
        std::size_t end = result.find(block ? "*/" : "\n", i + 2);
        end = end == std::string::npos ? result.size() : end + 2*block;
        for (; i < end; ++i)
        {
            result[i] = result[i] == '\n' ? '\n' : ' ';
        }
        --i;
    }
    return result;
}

} // namespace sph
