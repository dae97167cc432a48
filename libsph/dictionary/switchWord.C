#include "dictionary/switchWord.H"

#include <map>

namespace sph
{

std::optional<bool> switchValue(const Token& token)
{
    static const std::map<word, bool> values
    {
        {"yes", true}, {"no", false},
        {"on", true}, {"off", false},
        {"true", true}, {"false", false},
        {"y", true}, {"n", false},
        {"t", true}, {"f", false},
        {"any", true}, {"none", false}
    };

    if (token.kind == Token::Kind::number && token.isLabel)
    {
        return token.value != 0;
    }
    const auto found = values.find(token.text);
    if (token.kind != Token::Kind::word || found == values.end())
    {
        return std::nullopt;
    }
    return found->second;
}

} // namespace sph
