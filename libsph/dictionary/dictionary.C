#include "dictionary/dictionary.H"

#include "dictionary/contents.H"
#include "dictionary/files.H"
#include "dictionary/parser.H"
#include "dictionary/valueReader.H"

namespace sph
{

dictionary::dictionary()
:
    contents_(std::make_unique<Contents>())
{}

dictionary::dictionary(dictionary&&) noexcept = default;

dictionary& dictionary::operator=(dictionary&&) noexcept = default;

dictionary::~dictionary() = default;

dictionary dictionary::fromFile(const std::filesystem::path& file)
{
    return fromString(readText(file), file.string());
}

dictionary dictionary::fromString
(
    const std::string& text, const std::string& name
)
{
    dictionary result;
    *result.contents_ = Contents(name, "");
    result.contents_->startLine = 1;
    Parser(*result.contents_).read(text, name);
    return result;
}

dictionary dictionary::filledIn
(
    const std::string& text, const std::string& name
)
{
    dictionary result = fromString(text, name);
    result.contents_->setFillsIn();
    return result;
}

bool dictionary::fillsIn() const
{
    return contents_->fillsIn;
}

const std::string& dictionary::name() const
{
    return contents_->name;
}

const std::filesystem::path& dictionary::file() const
{
    return contents_->file;
}

label dictionary::startLine() const
{
    return contents_->startLine;
}

label dictionary::endLine() const
{
    return contents_->endLine;
}

wordList dictionary::toc() const
{
    wordList keywords;
    for (const auto& entry : contents_->entries)
    {
        keywords.push_back(entry->keyword);
    }
    return keywords;
}

bool dictionary::found(const Key& key) const
{
    contents_->note(key);
    return contents_->find(key.name);
}

bool dictionary::isDict(const Key& key) const
{
    contents_->note(key);
    const Entry* const entry = contents_->find(key.name);
    return entry && entry->dict;
}

const dictionary& dictionary::subDict(const Key& key) const
{
    const Entry& entry = contents_->require(key);
    if (!entry.dict)
    {
        throw IOError
        (
            "Entry '" + key.name + "' must be a dictionary { ... }, found '"
          + tokenText(entry.tokens) + "'",
            contents_->where(entry),
            entry.startLine,
            entry.endLine
        );
    }
    return *entry.dict;
}

const dictionary& dictionary::subOrEmptyDict(const Key& key) const
{
    if (found(key))
    {
        return subDict(key);
    }
    auto& empty = contents_->absent[key.name];
    if (!empty)
    {
        empty = Contents::make(contents_->file, contents_->subScope(key.name));
        Contents::of(*empty).fillsIn = contents_->fillsIn;
        Contents::of(*empty).startLine = contents_->startLine;
        Contents::of(*empty).endLine = contents_->endLine;
    }
    return *empty;
}

const dictionary& dictionary::optionalSubDict(const Key& key) const
{
    return isDict(key) ? subDict(key) : *this;
}

std::vector<std::pair<word, const dictionary*>> dictionary::dictList
(
    const Key& key
) const
{
    const Entry& entry = contents_->require(key);
    ValueReader reader(entry, contents_->where(entry));
    std::vector<std::pair<word, const dictionary*>> list;
    reader.readDictList(list);
    reader.finish();
    return list;
}

void dictionary::fail(const word& key, const std::string& message) const
{
    if (const Entry* const entry = contents_->find(key))
    {
        throw IOError
        (
            message,
            contents_->where(*entry),
            entry->startLine,
            entry->endLine
        );
    }
    throw IOError
    (
        message, contents_->name, contents_->startLine, contents_->endLine
    );
}

void dictionary::markUsed(const Key& key) const
{
    contents_->note(key);
    if (Entry* const entry = contents_->find(key.name))
    {
        sph::markUsed(*entry);
    }
}

} // namespace sph
