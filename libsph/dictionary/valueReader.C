#include "dictionary/valueReader.H"

#include "dictionary/switchWord.H"
#include "dictionary/units.H"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace sph
{

ValueReader::ValueReader(const Entry& entry, const std::string& where)
:
    entry_(entry),
    where_(where)
{}

void ValueReader::fail(const std::string& message, const label line) const
{
    throw IOError(message, where_, line);
}

const Token& ValueReader::ahead(const std::size_t n) const
{
    static const Token none;
    return at_ + n < entry_.tokens.size() ? entry_.tokens[at_ + n] : none;
}

void ValueReader::failType(const std::string& expected) const
{
    const std::string message =
        "Entry '" + entry_.keyword + "' must be " + expected + ", found ";
    if (entry_.dict)
    {
        fail(message + "a dictionary", entry_.startLine);
    }
    if (entry_.tokens.empty())
    {
        fail(message + "no value", entry_.startLine);
    }
    if (ahead().kind == Token::Kind::end)
    {
        fail
        (
            message + "nothing after '" + entry_.tokens.back().text + "'",
            entry_.tokens.back().line
        );
    }
    fail(message + ahead().description(), ahead().line);
}

const Token& ValueReader::take
(
    const Token::Kind kind, const std::string& expected
)
{
    if (ahead().kind != kind)
    {
        failType(expected);
    }
    return entry_.tokens[at_++];
}

void ValueReader::expect(const char punctuation, const std::string& expected)
{
    if (!ahead().is(punctuation))
    {
        failType(expected);
    }
    ++at_;
}

// Few characters must not fill the memory
void ValueReader::checkRepetitions(const label count) const
{
    constexpr label most = 1000000;
    if (count > most)
    {
        fail
        (
            "Entry '" + entry_.keyword + "' repeats a value "
          + std::to_string(count) + " times; at most "
          + std::to_string(most) + " are read",
            ahead().line
        );
    }
}

void ValueReader::read(scalar& value)
{
    value = take(Token::Kind::number, "a number").value;
}

void ValueReader::read(label& value)
{
    const Token& token = take(Token::Kind::number, "a whole number");
    const bool fits =
        token.value >= std::numeric_limits<label>::min()
     && token.value <= std::numeric_limits<label>::max();
    if (!token.isLabel || !fits)
    {
        --at_;
        failType
        (
            token.isLabel
          ? "a whole number of at most "
          + std::to_string(std::numeric_limits<label>::max())
          : "a whole number without point or exponent"
        );
    }
    value = static_cast<label>(token.value);
}

void ValueReader::read(bool& value)
{
    const auto found = switchValue(ahead());
    if (!found)
    {
        failType("a switch such as yes, no, on, off, true, false");
    }
    value = *found;
    ++at_;
}

void ValueReader::read(word& value)
{
    const bool isString =
        ahead().kind == Token::Kind::string
     || ahead().kind == Token::Kind::verbatim;
    value = take(isString ? ahead().kind : Token::Kind::word, "a word").text;
}

void ValueReader::read(vector& value)
{
    const std::string expected =
        "a vector of three components such as (0 -9.81 0)";
    scalar components[3];
    expect('(', expected);
    for (scalar& component : components)
    {
        component = take(Token::Kind::number, expected).value;
    }
    expect(')', expected);
    if (components[2] != 0)
    {
        fail
        (
            "The third component of the vector in entry '" + entry_.keyword
          + "' must be 0, not " + numberText(components[2])
          + ": the calculation is two-dimensional",
            entry_.tokens[at_ - 2].line
        );
    }
    value = vector(components[0], components[1]);
}

void ValueReader::read(dimensionSet& value)
{
    const std::string expected = "dimensions such as [0 1 -2 0 0 0 0]";
    const Token& token = take(Token::Kind::dimensions, expected);
    try
    {
        value = readUnit(token.text).dimensions;
    }
    catch (const std::invalid_argument& error)
    {
        fail("Entry '" + entry_.keyword + "': " + error.what(), token.line);
    }
}

scalar ValueReader::readDimensions(const dimensionSet& expected)
{
    if
    (
        ahead().kind == Token::Kind::word
     && ahead(1).kind != Token::Kind::end
    )
    {
        ++at_;
    }
    if (ahead().kind != Token::Kind::dimensions)
    {
        return 1;
    }
    dimensionSet given;
    read(given);
    const Token& token = entry_.tokens[at_ - 1];
    if (given != expected)
    {
        fail
        (
            "The dimensions " + given.str() + " of entry '" + entry_.keyword
          + "' are not the expected dimensions " + expected.str(),
            token.line
        );
    }
    return readUnit(token.text).factor;
}

void ValueReader::readDictList
(
    std::vector<std::pair<word, const dictionary*>>& list
)
{
    const std::string expected =
        "a list of dictionaries such as ( name { ... } name { ... } )";
    expect('(', expected);
    while (!ahead().is(')'))
    {
        word name;
        if (ahead().kind == Token::Kind::word)
        {
            name = ahead().text;
            ++at_;
        }
        const Token& token = take(Token::Kind::block, expected);
        list.emplace_back(name, token.block.get());
    }
    ++at_;
}

void ValueReader::finish() const
{
    if (ahead().kind == Token::Kind::end)
    {
        return;
    }
    const std::size_t count = entry_.tokens.size() - at_;
    const auto begin = entry_.tokens.begin() + at_;
    const TokenList excess(begin, begin + std::min<std::size_t>(count, 5));
    const label line = at_ > 0 ? entry_.tokens[at_ - 1].line : 0;
    const bool onNextLine = ahead().line > line;
    fail
    (
        "Entry '" + entry_.keyword + "' has " + std::to_string(count)
      + " excess token" + (count == 1 ? "" : "s") + ": '"
      + tokenText(excess) + (excess.size() < count ? " ..." : "") + "'"
      + (
            onNextLine
          ? "\n is a ';' missing at the end of line "
          + std::to_string(line) + "?"
          : ""
        ),
        line
    );
}

} // namespace sph
