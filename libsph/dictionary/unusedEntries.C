// Entries that nobody has looked up are misspelt, or of no effect.

#include "dictionary/contents.H"

namespace sph
{

namespace
{

std::string unusedMessage
(
    const Entry& entry, const dictionary::Contents& contents
)
{
    std::string message =
        "Entry '" + entry.keyword + "' of dictionary \"" + contents.name
      + "\" is not used.";

    // What was asked for and is not there
    wordList missing;
    const wordList asked = contents.asked();
    for (const word& keyword : asked)
    {
        if (!contents.find(keyword))
        {
            missing.push_back(keyword);
        }
    }
    const word meant = nearest(entry.keyword, missing);
    if (!meant.empty())
    {
        return message + "\n did you mean '" + meant + "'?";
    }
    if (asked.empty())
    {
        return message + "\n No entries are read from this dictionary.";
    }
    return message + "\n\nValid entries are :\n\n" + listOfWords(asked);
}

} // namespace


void dictionary::Contents::refuseUnused() const
{
    for (const auto& entry : entries)
    {
        const bool isHeader = scope.empty() && entry->keyword == "FoamFile";
        if (isHeader || (entry->expanded && !entry->used))
        {
            continue;
        }
        if (!entry->used)
        {
            throw IOError
            (
                unusedMessage(*entry, *this),
                where(*entry),
                entry->startLine,
                entry->endLine
            );
        }
        if (entry->dict)
        {
            of(*entry->dict).refuseUnused();
        }
        for (const Token& token : entry->tokens)
        {
            if (token.block)
            {
                of(*token.block).refuseUnused();
            }
        }
    }
}

void dictionary::refuseUnused() const
{
    contents_->refuseUnused();
}

} // namespace sph
