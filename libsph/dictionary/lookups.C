// What readers ask of a dictionary, and what is said if it is not there.

#include "dictionary/contents.H"

#include <algorithm>

namespace sph
{

Lookup& dictionary::Contents::note(const Key& key)
{
    const auto known = std::find_if
    (
        lookups.begin(), lookups.end(),
        [&](const Lookup& lookup) { return lookup.key.name == key.name; }
    );
    Lookup& lookup =
        known == lookups.end() ? lookups.emplace_back(Lookup{key}) : *known;
    if (lookup.key.meaning.empty())
    {
        lookup.key = key;
    }
    return lookup;
}

Lookup& dictionary::Contents::noteKind
(
    const Key& key, const std::string& kind
)
{
    Lookup& lookup = note(key);
    if (lookup.kind.empty())
    {
        lookup.kind = kind;
    }
    return lookup;
}

wordList dictionary::Contents::asked() const
{
    wordList keywords;
    for (const Lookup& lookup : lookups)
    {
        keywords.push_back(lookup.key.name);
    }
    return keywords;
}

Entry* dictionary::Contents::lookup(const Key& key)
{
    note(key);
    Entry* entry = find(key.name);
    if (entry)
    {
        entry->used = true;
    }
    return entry;
}

Entry& dictionary::Contents::require(const Key& key)
{
    if (fillsIn && !key.sample.empty() && !find(key.name))
    {
        fillIn(key);
    }
    if (Entry* entry = lookup(key))
    {
        return *entry;
    }
    const word& keyword = key.name;
    std::string message =
        "Entry '" + keyword + "' not found in dictionary \"" + name + '"';
    failIfSwallowed(keyword, message);
    // What nobody has read is the likelier slip
    word near = nearest(keyword, unreadKeywords());
    if (near.empty())
    {
        near = nearest(keyword, literalKeywords());
    }
    if (const Entry* entry = near.empty() ? nullptr : find(near))
    {
        message +=
            "\n is '" + near + "' at line " + std::to_string(entry->startLine)
          + " meant to be it?";
    }
    if (!key.meaning.empty())
    {
        message += "\n " + keyword + ": " + key.meaning;
    }
    throw IOError(message, name, startLine, endLine);
}

void dictionary::Contents::fillIn(const Key& key)
{
    const bool isDict = key.sample[0] == '{';
    dictionary sample = fromString
    (
        key.name + ' ' + key.sample + (isDict ? "" : ";"), name
    );
    for (auto& entry : of(sample).entries)
    {
        insert(entry->clone(subScope(entry->keyword)));
    }
    setFillsIn();
}

void dictionary::Contents::setFillsIn()
{
    fillsIn = true;
    for (const auto& entry : entries)
    {
        if (entry->dict)
        {
            of(*entry->dict).setFillsIn();
        }
        for (const Token& token : entry->tokens)
        {
            if (token.block)
            {
                of(*token.block).setFillsIn();
            }
        }
    }
}

void dictionary::Contents::failIfSwallowed
(
    const word& keyword, const std::string& message
) const
{
    for (const auto& entry : entries)
    {
        label depth = 0;
        for (std::size_t i = 1; i < entry->tokens.size(); ++i)
        {
            const Token& token = entry->tokens[i];
            const label line = entry->tokens[i - 1].line;
            depth += entry->tokens[i - 1].is('(') - token.is(')');
            const bool swallowed =
                token.kind == Token::Kind::word && token.text == keyword
             && token.line > line && depth == 0;
            if (swallowed)
            {
                throw IOError
                (
                    message + "\n is a ';' missing at the end of line "
                  + std::to_string(line) + ", in entry '" + entry->keyword
                  + "'?",
                    where(*entry),
                    line
                );
            }
        }
    }
}

void dictionary::Contents::markUsed()
{
    for (const auto& entry : entries)
    {
        sph::markUsed(*entry);
    }
}

void markUsed(Entry& entry)
{
    entry.used = true;
    if (entry.dict)
    {
        dictionary::Contents::of(*entry.dict).markUsed();
    }
    for (const Token& token : entry.tokens)
    {
        if (token.block)
        {
            dictionary::Contents::of(*token.block).markUsed();
        }
    }
}

} // namespace sph
