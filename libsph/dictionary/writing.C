// Dictionaries as text.

#include "dictionary/contents.H"

#include <algorithm>
#include <ostream>
#include <sstream>

namespace sph
{

namespace
{

std::string padded(std::string keyword)
{
    keyword.resize(std::max<std::size_t>(keyword.size() + 1, 16), ' ');
    return keyword;
}

// inf and nan cannot be read back
bool isReadable(const std::string& value)
{
    return value.find("inf") == std::string::npos
     && value.find("nan") == std::string::npos;
}

} // namespace


std::string dictionary::Contents::inlineText(const TokenStyle style) const
{
    std::string text = "{ ";
    for (const auto& entry : entries)
    {
        text += entry->keywordText() + ' ';
        text += entry->dict
          ? of(*entry->dict).inlineText(style) + ' '
          : entry->tokens.empty() ? "; "
          : tokenText(entry->tokens, style) + " ; ";
    }
    return text + "}";
}

bool dictionary::Contents::filledByDefaults() const
{
    return
        !absent.empty()
     || std::any_of
        (
            lookups.begin(), lookups.end(),
            [](const Lookup& lookup) { return bool(lookup.defaultValue); }
        );
}

void dictionary::Contents::write
(
    std::ostream& os,
    const label depth,
    const TokenStyle style,
    const bool withDefaults
) const
{
    const std::string indent(4*depth, ' ');

    const auto writeBlock = [&](const std::string& key, const dictionary& dict)
    {
        os << indent << key << '\n' << indent << "{\n";
        of(dict).write(os, depth + 1, style, withDefaults);
        os << indent << "}\n";
    };

    for (const auto& entry : entries)
    {
        if (withDefaults && entry->expanded && !entry->used)
        {
            continue;
        }
        if (entry->dict)
        {
            writeBlock(entry->keywordText(), *entry->dict);
        }
        else if (entry->tokens.empty())
        {
            os << indent << entry->keywordText() << ";\n";
        }
        else
        {
            os  << indent << padded(entry->keywordText())
                << tokenText(entry->tokens, style) << ";\n";
        }
    }
    if (!withDefaults)
    {
        return;
    }
    for (const Lookup& lookup : lookups)
    {
        const word& keyword = lookup.key.name;
        if (lookup.defaultValue && !find(keyword))
        {
            const std::string& value = *lookup.defaultValue;
            os  << indent << (isReadable(value) ? "" : "// ")
                << padded(keyword) << value << ";    // default\n";
        }
    }
    for (const auto& [keyword, dict] : absent)
    {
        if (of(*dict).filledByDefaults())
        {
            writeBlock(keyword, *dict);
        }
    }
}

void dictionary::writeEffective(std::ostream& os) const
{
    contents_->write(os, 0, TokenStyle::asTyped, true);
}

std::string dictionary::text() const
{
    const TokenStyle style = TokenStyle::evaluated;
    std::string text;
    for (const auto& entry : contents_->entries)
    {
        if (entry->keyword != "FoamFile")
        {
            text += entry->keywordText() + ' '
              + (entry->dict ? Contents::of(*entry->dict).inlineText(style)
                             : tokenText(entry->tokens, style)) + '\n';
        }
    }
    return text;
}

std::string dictionary::valueText(const Key& scopedKey) const
{
    contents_->note(scopedKey);
    Entry* entry = contents_->findScoped(scopedKey.name);
    if (!entry)
    {
        entry = &contents_->require(scopedKey);
    }
    sph::markUsed(*entry);
    if (!entry->dict)
    {
        return tokenText(entry->tokens);
    }
    std::ostringstream os;
    os << "{\n";
    Contents::of(*entry->dict).write(os, 1, TokenStyle::evaluated, false);
    os << "}";
    return os.str();
}

} // namespace sph
