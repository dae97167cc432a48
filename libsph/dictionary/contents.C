#include "dictionary/contents.H"

#include "dictionary/keywordPattern.H"

#include <algorithm>

namespace sph
{

std::unique_ptr<Entry> Entry::clone(const std::string& scope) const
{
    auto copy = std::make_unique<Entry>();
    copy->keyword = keyword;
    copy->pattern = pattern;
    copy->file = file;
    copy->startLine = startLine;
    copy->endLine = endLine;
    copy->tokens = tokens;
    copy->expanded = expanded;
    for (Token& token : copy->tokens)
    {
        if (token.block)
        {
            token.block = dictionary::Contents::of(*token.block).clone(scope);
        }
    }
    if (dict)
    {
        copy->dict = dictionary::Contents::of(*dict).clone(scope);
    }
    return copy;
}

std::size_t Entry::footprint(const std::string& scope) const
{
    std::size_t size = sizeof(Entry) + keyword.size() + file.size();
    for (const Token& token : tokens)
    {
        size += sizeof(Token) + token.text.size();
        if (token.block)
        {
            size += dictionary::Contents::of(*token.block).footprint(scope);
        }
    }
    return
        dict ? size + dictionary::Contents::of(*dict).footprint(scope) : size;
}

std::string Entry::keywordText() const
{
    return pattern ? quoted(keyword) : keyword;
}


dictionary::Contents::Contents
(
    const std::filesystem::path& path, const std::string& inScope
)
:
    file(path),
    scope(inScope),
    name(path.string() + (inScope.empty() ? "" : "." + inScope))
{}

std::unique_ptr<dictionary> dictionary::Contents::make
(
    const std::filesystem::path& file, const std::string& scope
)
{
    auto dict = std::make_unique<dictionary>();
    dict->contents_ = std::make_unique<Contents>(file, scope);
    return dict;
}

Entry* dictionary::Contents::findLiteral
(
    const word& keyword, const bool isPattern
) const
{
    const auto& index = isPattern ? patterns : literals;
    const auto found = index.find(keyword);
    return found == index.end() ? nullptr : found->second;
}

Entry* dictionary::Contents::find
(
    const word& keyword, const bool withPatterns
) const
{
    if (Entry* entry = findLiteral(keyword))
    {
        return entry;
    }
    if (!withPatterns || patterns.empty() || keyword.size() > maxKeyword)
    {
        return nullptr;
    }
    for (auto iter = entries.rbegin(); iter != entries.rend(); ++iter)
    {
        const auto& pattern = (*iter)->pattern;
        if (pattern && std::regex_match(keyword, *pattern))
        {
            return iter->get();
        }
    }
    return nullptr;
}

Entry* dictionary::Contents::findScoped
(
    const word& path, const bool withPatterns
) const
{
    std::set<std::pair<const Contents*, std::size_t>> searched;
    return findScoped(path, withPatterns, searched);
}

Entry* dictionary::Contents::findScoped
(
    const word& path, const bool withPatterns,
    std::set<std::pair<const Contents*, std::size_t>>& searched
) const
{
    if (Entry* entry = findLiteral(path))
    {
        return entry;
    }
    if (!searched.insert({this, path.size()}).second)
    {
        return nullptr;
    }
    for
    (
        std::size_t dot = path.find('.');
        dot != std::string::npos;
        dot = path.find('.', dot + 1)
    )
    {
        const Entry* entry = find(path.substr(0, dot), withPatterns);
        Entry* const below = !entry || !entry->dict
          ? nullptr
          : of(*entry->dict).findScoped
            (
                path.substr(dot + 1), withPatterns, searched
            );
        if (below)
        {
            return below;
        }
    }
    return find(path, withPatterns);
}

void dictionary::Contents::insert(std::unique_ptr<Entry> entry)
{
    Entry* present = findLiteral(entry->keyword, bool(entry->pattern));
    if (!present)
    {
        append(std::move(entry));
    }
    else if (present->dict && entry->dict)
    {
        for (auto& subEntry : of(*entry->dict).entries)
        {
            of(*present->dict).insert(std::move(subEntry));
        }
    }
    else
    {
        *present = std::move(*entry);
    }
}

void dictionary::Contents::append(std::unique_ptr<Entry> entry)
{
    (entry->pattern ? patterns : literals)[entry->keyword] = entry.get();
    entries.push_back(std::move(entry));
}

void dictionary::Contents::remove(const Entry* entry)
{
    if (!entry)
    {
        return;
    }
    (entry->pattern ? patterns : literals).erase(entry->keyword);
    entries.erase
    (
        std::remove_if
        (
            entries.begin(),
            entries.end(),
            [=](const auto& candidate) { return candidate.get() == entry; }
        ),
        entries.end()
    );
}

std::unique_ptr<dictionary> dictionary::Contents::clone
(
    const std::string& newScope
) const
{
    auto copy = make(file, newScope);
    Contents& to = of(*copy);
    to.startLine = startLine;
    to.endLine = endLine;
    for (const auto& entry : entries)
    {
        to.append(entry->clone(to.subScope(entry->keyword)));
    }
    return copy;
}

std::string dictionary::Contents::subScope(const word& keyword) const
{
    return scope.empty() ? keyword : scope + "." + keyword;
}

std::size_t dictionary::Contents::footprint(const std::string& newScope) const
{
    std::size_t size = sizeof(Contents) + 2*newScope.size();
    for (const auto& entry : entries)
    {
        size += entry->footprint(newScope + "." + entry->keyword);
    }
    return size;
}

wordList dictionary::Contents::literalKeywords() const
{
    wordList keywords;
    for (const auto& entry : entries)
    {
        if (!entry->pattern)
        {
            keywords.push_back(entry->keyword);
        }
    }
    return keywords;
}

wordList dictionary::Contents::unreadKeywords() const
{
    wordList keywords;
    for (const auto& entry : entries)
    {
        if (!entry->pattern && !entry->used)
        {
            keywords.push_back(entry->keyword);
        }
    }
    return keywords;
}

std::string dictionary::Contents::where(const Entry& entry) const
{
    return entry.file + (scope.empty() ? "" : "." + scope);
}

} // namespace sph
