#include "selection/Selectable.H"

namespace sph
{

std::map<word, SelectionTables::Table>& SelectionTables::all()
{
    static std::map<word, Table> tables;
    return tables;
}

void SelectionTables::add
(
    const word& family, const word& keyword, const std::string& description
)
{
    if (!all()[family].emplace(keyword, description).second)
    {
        throw Error
        (
            "The " + family + " keyword '" + keyword + "' is registered twice"
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
