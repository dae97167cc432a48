#include "setup/FieldExpression.H"

#include "dictionary/contents.H"
#include "dictionary/expressionValue.H"

#include <sstream>

namespace sph
{

FieldExpression::FieldExpression
(
    const dictionary& dict, const Key& key,
    std::vector<const dictionary*> around
)
:
    dict_(dict),
    key_(key.name),
    around_(std::move(around))
{
    around_.push_back(&dict);
    const Entry& entry = dictionary::Contents::of(dict).require(key);
    using Kind = Token::Kind;
    const bool isText =
        entry.tokens.size() == 1
     && (
            entry.tokens[0].kind == Kind::string
         || entry.tokens[0].kind == Kind::verbatim
         || entry.tokens[0].kind == Kind::word
         || entry.tokens[0].kind == Kind::number
        );
    if (!isText)
    {
        dict.fail
        (
            key_, "Entry '" + key_ + "' must be an expression in quotes, such"
            " as \"0.5*y\""
        );
    }
    const Token& token = entry.tokens[0];
    text_ =
        token.kind == Kind::number ? numberText(token.value) : token.text;
}

const ExpressionValue& FieldExpression::macro(const std::string& name)
{
    const auto remembered = macros_.find(name);
    if (remembered != macros_.end())
    {
        return remembered->second;
    }
    wordList known;
    for (auto dict = around_.rbegin(); dict != around_.rend(); ++dict)
    {
        auto& contents = dictionary::Contents::of(**dict);
        if (Entry* const entry = contents.findScoped(name, false))
        {
            (*dict)->markUsed(name.substr(0, name.find('.')));
            return macros_[name] = expressionValue(name, entry->tokens);
        }
        const wordList keywords = contents.literalKeywords();
        known.insert(known.end(), keywords.begin(), keywords.end());
    }
    const word meant = nearest(name, known);
    throw std::invalid_argument
    (
        "undefined macro '$" + name + "'"
      + (meant.empty() ? "" : ", did you mean '$" + meant + "'?")
    );
}

scalar FieldExpression::operator()(const vector& r)
{
    try
    {
        const ExpressionValue value = evaluate
        (
            text_,
            [&](const std::string& name) { return macro(name); },
            {{"x", r.x()}, {"y", r.y()}}
        );
        if (value.isVector)
        {
            throw ExpressionError("a number is needed, not a vector", 0);
        }
        return value.v[0];
    }
    catch (const ExpressionError& error)
    {
        std::ostringstream text;
        text
            << "In the expression '" << text_ << "' of entry '" << key_
            << "', at (" << r.x() << ' ' << r.y() << " 0): " << error.what();
        dict_.fail(key_, text.str());
    }
}

} // namespace sph
