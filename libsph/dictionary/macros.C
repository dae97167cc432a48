// $name and ${name}: entries and environment variables, taken as they stand
// when the macro is read.

#include "dictionary/keywordPattern.H"
#include "dictionary/parser.H"

#include <algorithm>
#include <cctype>
#include <cstdlib>

namespace sph
{

// From one of the dictionaries around, by the dotted path
Entry* Parser::findFrom
(
    const std::size_t level, const std::string& name, const std::string& path
) const
{
    if (level >= scopes_.size())
    {
        throw std::invalid_argument
        (
            "There is no dictionary so far up as '$" + name + "' says"
        );
    }
    return scopes_[level]->findScoped(path);
}

// /grain/d from the top, ../grain/d from the dictionary around this one
Entry* Parser::findPath(const std::string& name) const
{
    std::size_t level = name[0] == '/' ? 0 : scopes_.size() - 1;
    std::string path;
    for (std::size_t begin = 0; begin <= name.size(); )
    {
        const std::size_t end = std::min(name.find('/', begin), name.size());
        const std::string part = name.substr(begin, end - begin);
        begin = end + 1;
        if (part == "..")
        {
            --level;   // above the top it wraps and is refused
        }
        else if (!part.empty() && part != ".")
        {
            path += (path.empty() ? "" : ".") + part;
        }
    }
    return findFrom(level, name, path);
}

Entry* Parser::findVariable(const std::string& name) const
{
    if (name[0] == ':')
    {
        return findFrom(0, name, name.substr(1));
    }
    if (name.find('/') != std::string::npos)
    {
        return findPath(name);
    }
    if (name[0] == '.')
    {
        const std::size_t dots = std::min
        (
            name.find_first_not_of('.'), name.size()
        );
        return findFrom(scopes_.size() - dots, name, name.substr(dots));
    }
    for (const bool patterns : {false, true})
    {
        for (auto scope = scopes_.rbegin(); scope != scopes_.rend(); ++scope)
        {
            if (Entry* entry = (*scope)->findScoped(name, patterns))
            {
                return entry;
            }
        }
    }
    return nullptr;
}

TokenList Parser::entryTokens(Entry& entry, const label line) const
{
    constexpr std::size_t most = 20000000;
    expanded_ += entry.footprint(here().scope);
    if (expanded_ > most)
    {
        throw std::invalid_argument
        (
            "The macros stand for more than "
          + std::to_string(most/1000000) + " MB of entries"
        );
    }
    const auto copy = entry.clone(here().scope);
    entry.expanded = true;
    if (copy->dict)
    {
        Token block;
        block.kind = Token::Kind::block;
        block.block = std::move(copy->dict);
        copy->tokens = {block};
    }
    for (Token& token : copy->tokens)
    {
        token.line = line;
    }
    return copy->tokens;
}

TokenList Parser::variableTokens
(
    const std::string& fullName, const label line
) const
{
    // ${name:-default}
    const std::string plain = expandText(fullName, line);
    const std::size_t mark = plain.find(":-");
    const std::string name = plain.substr(0, mark);

    const auto tokenise = [&](const std::string& text)
    {
        TokenList tokens;
        Tokeniser in(text, in_->file(), line);
        while (in.peek().kind != Token::Kind::end)
        {
            tokens.push_back(in.next());
        }
        return tokens;
    };

    if (name.size() > maxKeyword)
    {
        throw std::invalid_argument
        (
            "A macro of " + std::to_string(name.size())
          + " characters is too long"
        );
    }
    if (Entry* const entry = name.empty() ? nullptr : findVariable(name))
    {
        return entryTokens(*entry, line);
    }
    if (const char* const value = std::getenv(name.c_str()))
    {
        const std::string text = value;
        if (text.find_first_of("/\"$#'\\") == std::string::npos)
        {
            return tokenise(text);
        }
        Token token = Token::word(text, line);
        token.kind = Token::Kind::string;
        return {token};
    }
    if (mark != std::string::npos)
    {
        return tokenise(plain.substr(mark + 2));
    }

    wordList known;
    for (const Contents* scope : scopes_)
    {
        const wordList keywords = scope->literalKeywords();
        known.insert(known.end(), keywords.begin(), keywords.end());
    }
    const word meant = nearest(name, known);
    throw std::invalid_argument
    (
        "Undefined macro '$" + name
      + "': there is no such entry and no such environment variable"
      + (meant.empty() ? "" : "\n did you mean '" + meant + "'?")
    );
}

TokenList Parser::expand(const Token& variable) const
{
    try
    {
        return variableTokens(variable.text, variable.line);
    }
    catch (const std::invalid_argument& error)
    {
        fail(error.what(), variable.line);
    }
}

void Parser::expandEntries(const Token& variable)
{
    const TokenList tokens = expand(variable);
    if (tokens.size() == 1 && tokens[0].block)
    {
        for (auto& entry : Contents::of(*tokens[0].block).entries)
        {
            store(entry->clone(here().subScope(entry->keyword)));
        }
        return;
    }
    if (tokens.size() == 1 && tokens[0].kind == Token::Kind::word)
    {
        readEntry(tokens[0]);
        return;
    }
    fail
    (
        "'$" + variable.text + "' in place of an entry must stand for a "
        "dictionary or a keyword, not for '" + tokenText(tokens) + "'",
        variable.line
    );
}

std::string Parser::expandText
(
    const std::string& text, const label line
) const
{
    if (std::count(text.begin(), text.end(), '{') > 50)
    {
        fail("The macros are nested too deeply", line);
    }
    std::string result;
    for (std::size_t at = 0; at < text.size(); )
    {
        if (text[at] != '$' || at + 1 == text.size())
        {
            result += text[at++];
            continue;
        }
        Token variable;
        variable.kind = Token::Kind::variable;
        variable.line = line;
        ++at;
        if (text[at] == '{')
        {
            label depth = 0;
            std::size_t end = at;
            do
            {
                depth += (text[end] == '{') - (text[end] == '}');
            }
            while (++end < text.size() && depth > 0);
            variable.text = text.substr(at + 1, end - at - 2);
            at = end;
        }
        else
        {
            while
            (
                at < text.size()
             && (
                    std::isalnum(static_cast<unsigned char>(text[at]))
                 || std::string("_.:").find(text[at]) != std::string::npos
                )
            )
            {
                variable.text += text[at++];
            }
        }
        const TokenList tokens = expand(variable);
        const bool plain =
            tokens.size() == 1 && tokens[0].kind == Token::Kind::string;
        result += plain ? tokens[0].text : tokenText(tokens);
    }
    return result;
}

} // namespace sph
