// What readers ask of a dictionary, and what is said if it is not there.

#include "dictionary/contents.H"

namespace sph
{

Entry* dictionary::Contents::lookup(const word& keyword)
{
    asked.insert(keyword);
    Entry* entry = find(keyword);
    if (entry)
    {
        entry->used = true;
    }
    return entry;
}

Entry& dictionary::Contents::require(const word& keyword)
{
    if (Entry* entry = lookup(keyword))
    {
        return *entry;
    }
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
    throw IOError(message, name, startLine, endLine);
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

void dictionary::Contents::recordDefault
(
    const word& keyword, const std::string& value
)
{
    for (auto& known : defaults)
    {
        if (known.first == keyword)
        {
            known.second = value;
            return;
        }
    }
    defaults.emplace_back(keyword, value);
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
