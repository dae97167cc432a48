#include "selection/Selectable.H"

#include "dictionary/contents.H"

namespace sph
{

std::map<word, SelectionTables::Table>& SelectionTables::all()
{
    static std::map<word, Table> tables;
    return tables;
}

static wordList& duplicates()
{
    static wordList list;
    return list;
}

void SelectionTables::add
(
    const word& family, const word& keyword, const std::string& description
)
{
    if (!all()[family].emplace(keyword, description).second)
    {
        duplicates().push_back(family + ' ' + keyword);
    }
}

void SelectionTables::checkUnique()
{
    if (!duplicates().empty())
    {
        throw Error
        (
            "Models registered twice under one keyword:\n"
          + listOfWords(duplicates())
        );
    }
}

const dictionary& SelectionTables::coefficients
(
    const dictionary& dict, const word& entry,
    const word& family, const word& keyword
)
{
    auto& contents = dictionary::Contents::of(dict);
    contents.note(entry).family = family;
    const word wanted = keyword + "Coeffs";
    if (contents.fillsIn && entry != "type")
    {
        return dict.subOrEmptyDict(wanted);
    }
    for (const auto& [other, description] : all()[family])
    {
        if (other != keyword && dict.found(other + "Coeffs"))
        {
            dict.markUsed(other + "Coeffs");
        }
    }
    if (dict.found(wanted))
    {
        return dict.subDict(wanted);
    }
    for (const word& key : dict.toc())
    {
        const bool coeffs =
            key.size() > 6 && key.compare(key.size() - 6, 6, "Coeffs") == 0;
        bool other = false;
        for (const auto& [familyName, table] : all())
        {
            other = other || (coeffs && table.count(key.substr(0, key.size() - 6)));
        }
        if (coeffs && !other && !nearest(key, {wanted}).empty())
        {
            dict.fail
            (
                key, "No " + family + " has the coefficients '" + key
              + "': did you mean '" + wanted + "'?"
            );
        }
    }
    return dict;
}

void SelectionTables::explainCoefficients
(
    const IOError& error, const word& keyword
)
{
    const std::string message = error.what();
    if (message.find("not found") != std::string::npos)
    {
        throw IOError
        (
            message + "\n The coefficients of " + keyword + " stand in "
          + keyword + "Coeffs or beside the keyword",
            error.file(), error.startLine(), error.endLine()
        );
    }
}

void SelectionTables::unknown
(
    const dictionary& dict, const word& entry,
    const word& family, const word& keyword
)
{
    wordList valid;
    for (const auto& [name, description] : all()[family])
    {
        valid.push_back(name);
    }
    std::string message = "Unknown " + family + " type " + keyword;
    const word near = nearest(keyword, valid);
    if (!near.empty())
    {
        message += ": did you mean '" + near + "'?";
    }
    dict.fail
    (
        entry,
        message + "\n\nValid " + family + " types :\n\n" + listOfWords(valid)
    );
}

} // namespace sph
