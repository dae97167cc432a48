#include "dictionary/expressionText.H"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstring>

namespace sph
{

namespace
{

bool isAlphanumeric(const char c)
{
    return std::isalnum(static_cast<unsigned char>(c));
}

} // namespace


void ExpressionText::fail(const std::string& message) const
{
    fail(message, at_);
}

void ExpressionText::fail
(
    const std::string& message, const std::size_t position
) const
{
    throw ExpressionError(message, std::min(position, text_.size()));
}

char ExpressionText::ahead()
{
    while
    (
        at_ < text_.size()
     && std::isspace(static_cast<unsigned char>(text_[at_]))
    )
    {
        ++at_;
    }
    return at_ < text_.size() ? text_[at_] : '\0';
}

bool ExpressionText::take(const char* const symbol)
{
    ahead();
    const std::size_t size = std::strlen(symbol);
    if (text_.compare(at_, size, symbol) != 0)
    {
        return false;
    }
    at_ += size;
    return true;
}

void ExpressionText::expect
(
    const char* const symbol, const std::string& purpose
)
{
    if (take(symbol))
    {
        return;
    }
    const std::string wanted = "'" + std::string(symbol) + "' " + purpose;
    fail
    (
        at_ < text_.size()
      ? "expected " + wanted + ", found '" + text_[at_] + "'"
      : wanted + " is missing"
    );
}

scalar ExpressionText::number()
{
    scalar value = 0;
    const char* const begin = text_.data() + at_;
    const auto result =
        std::from_chars(begin, text_.data() + text_.size(), value);
    if (result.ec != std::errc())
    {
        fail("a number cannot be read");
    }
    at_ += result.ptr - begin;
    return value;
}

std::string ExpressionText::name()
{
    const std::size_t begin = at_;
    while (at_ < text_.size() && isAlphanumeric(text_[at_]))
    {
        ++at_;
    }
    return text_.substr(begin, at_ - begin);
}

std::string ExpressionText::variable()
{
    const std::size_t begin = ++at_;
    if (at_ < text_.size() && text_[at_] == '{')
    {
        label depth = 0;
        do
        {
            depth += (text_[at_] == '{') - (text_[at_] == '}');
            ++at_;
        }
        while (at_ < text_.size() && depth > 0);
        return text_.substr(begin + 1, at_ - begin - 2);
    }
    at_ += at_ < text_.size() && text_[at_] == ':';
    while
    (
        at_ < text_.size()
     && (isAlphanumeric(text_[at_]) || text_[at_] == '_' || text_[at_] == '.')
    )
    {
        ++at_;
    }
    return text_.substr(begin, at_ - begin);
}

void ExpressionText::failOperand()
{
    const char c = ahead();
    fail
    (
        c ? "a number is missing before '" + std::string(1, c) + "'"
      : text_.find_first_not_of(" \t\r\n") == std::string::npos
      ? "the expression is empty"
      : "a number is missing at the end"
    );
}

} // namespace sph
