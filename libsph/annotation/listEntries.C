#include "annotation/listEntries.H"

#include "annotation/sources.H"
#include "annotation/writeEntries.H"

#include "selection/Selectable.H"

#include <algorithm>
#include <ostream>

namespace sph
{

namespace
{

const ReadEntry* find(const ReadEntries& entries, const word& name)
{
    for (const ReadEntry& entry : entries)
    {
        if (entry.lookup.key.name == name)
        {
            return &entry;
        }
    }
    return nullptr;
}


// The dictionary of a model: its coefficients, or all of it where it has a name
ReadEntries blockOf(const FamilySource& source, const word& model)
{
    const bool named = source.entry == "type";
    const ReadEntries entries = explore
    (
        named
      ? model + " { type " + model + "; }" : source.entry + ' ' + model + ';',
        source.read
    );
    const ReadEntry* const found = find
    (
        entries, named ? model : model + "Coeffs"
    );
    if (!found || found->entries.empty())
    {
        return {};
    }
    ReadEntry block = *found;
    block.lookup.key.meaning =
        model + ": " + SelectionTables::all()[source.family][model];
    return {block};
}


// The entry that selects a model
ReadEntry selection(const FamilySource& source)
{
    return *find(explore("", source.read), source.entry);
}


// A model of a user's own may have entries without samples
std::string failure(const word& model, const Error& error)
{
    const std::string what = error.what();
    return "\n// " + model + ": " + what.substr(0, what.find('\n')) + '\n';
}


void listFamily(std::ostream& os, const FamilySource& source)
{
    writeHeader
    (
        os, "All entries of all models of the family " + source.family
      + ", which stand in " + source.place + '.',
        "granularFoamSPH -listEntries " + source.family
    );
    const auto& models = SelectionTables::all()[source.family];
    ReadEntries entries;
    if (source.entry != "type")
    {
        entries.push_back(selection(source));
    }
    std::string unknown;
    for (const auto& [model, description] : models)
    {
        try
        {
            const ReadEntries block = blockOf(source, model);
            entries.insert(entries.end(), block.begin(), block.end());
        }
        catch (const Error& error)
        {
            unknown += failure(model, error);
        }
    }
    writeEntries(os, entries);
    os << unknown;
}


void listModel
(
    std::ostream& os, const FamilySource& source, const word& model
)
{
    os << "// In " << source.place << ":\n\n";
    ReadEntries entries;
    std::string unknown;
    try
    {
        entries = blockOf(source, model);
    }
    catch (const Error& error)
    {
        unknown = failure(model, error);
    }
    if (source.entry != "type")
    {
        ReadEntry selected = selection(source);
        selected.value = model;
        selected.lookup.family.clear();
        entries.insert(entries.begin(), selected);
    }
    writeEntries(os, entries);
    os << unknown << '\n';
}


[[noreturn]] void unknown(const word& name)
{
    wordList valid = listedDictionaries();
    const auto& families = SelectionTables::all();
    for (const auto& [family, models] : families)
    {
        valid.push_back(family);
        for (const auto& [model, description] : models)
        {
            valid.push_back(model);
        }
    }
    std::sort(valid.begin(), valid.end());
    valid.erase(std::unique(valid.begin(), valid.end()), valid.end());
    const word guess = nearest(name, valid);
    throw Error
    (
        "There is no dictionary, family or model " + name
      + (guess.empty() ? "" : "; did you mean '" + guess + "'?")
      + "\n\nValid names :\n\n" + listOfWords(valid)
    );
}

} // namespace


void listEntries(std::ostream& os, const word& name, const scalar spacing)
{
    Specimen specimen(spacing);
    bool listed = false;
    for (const DictionarySource& source : dictionarySources(specimen))
    {
        if (source.name == name)
        {
            writeDictionary
            (
                os, source.place, "granularFoamSPH -listEntries " + name,
                source.read
            );
            return;
        }
    }
    const auto families = familySources(specimen);
    for (const FamilySource& source : families)
    {
        if (source.family == name)
        {
            listFamily(os, source);
            return;
        }
    }
    for (const FamilySource& source : families)
    {
        if (SelectionTables::all()[source.family].count(name) > 0)
        {
            listModel(os, source, name);
            listed = true;
        }
    }
    if (!listed)
    {
        unknown(name);
    }
}


wordList listedDictionaries()
{
    Specimen specimen(0.01);
    wordList names;
    for (const DictionarySource& source : dictionarySources(specimen))
    {
        names.push_back(source.name);
    }
    return names;
}


wordList listedFamilies()
{
    Specimen specimen(0.01);
    wordList names;
    for (const FamilySource& source : familySources(specimen))
    {
        names.push_back(source.family);
    }
    return names;
}

} // namespace sph
