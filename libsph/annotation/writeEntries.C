#include "annotation/writeEntries.H"

#include "selection/Selectable.H"

#include <ostream>
#include <sstream>

namespace sph
{

namespace
{

// Words into lines of at most 80 columns that begin in the same way, after
// what stands on the first one
void writeWrapped
(
    std::ostream& os, const std::string& begin, const std::string& text,
    const std::string& first = ""
)
{
    std::istringstream words(text);
    std::string line = first.empty() ? begin : first;
    for (std::string word; words >> word; )
    {
        if (line.size() + 1 + word.size() > 80)
        {
            os << line << '\n';
            line = begin;
        }
        line += ' ' + word;
    }
    os << line << '\n';
}

// "one of cap Papanastasiou", "greater than 0"; empty if anything goes
std::string restrictions(const Lookup& lookup)
{
    if (!lookup.choices.empty())
    {
        std::string text = "one of";
        for (const word& choice : lookup.choices)
        {
            text += ' ' + choice;
        }
        return text;
    }
    const bool any = lookup.range.str() == Range::any().str();
    return
        lookup.kind == "yes or no" ? lookup.kind
      : lookup.kind == "whole number"
      ? lookup.kind + (any ? "" : ", " + lookup.range.str())
      : any ? "" : lookup.range.str();
}

// "[0 1 0 0 0 0 0] 0.1"
std::string dimensioned(const ReadEntry& entry)
{
    const auto& dims = entry.lookup.dims;
    return dims && *dims != dimless ? dims->str() + ' ' + entry.value
      : entry.value;
}

bool readsBack(const std::string& value)
{
    return value.find("inf") == std::string::npos;
}

void write(std::ostream& os, const ReadEntries&, const std::string& begin);

void writeComment
(
    std::ostream& os, const ReadEntry& entry, const std::string& begin
)
{
    const Lookup& lookup = entry.lookup;
    std::string text = lookup.key.meaning;
    const std::string limits = restrictions(lookup);
    if (!limits.empty())
    {
        text += (text.empty() ? "" : "; ") + limits;
    }
    if (!entry.condition.empty())
    {
        text += "; with " + entry.condition;
    }
    if (!text.empty())
    {
        writeWrapped(os, begin + "//", text);
    }
    if (!lookup.family.empty() && lookup.key.name != "type")
    {
        for (const auto& [model, is] : SelectionTables::all()[lookup.family])
        {
            std::string first = begin + "//     " + model;
            first.resize(begin.size() + 32, ' ');
            writeWrapped
            (
                os, begin + "//" + std::string(30, ' '), is, first
            );
        }
    }
}

void writeValue
(
    std::ostream& os, const ReadEntry& entry, const std::string& begin
)
{
    const Lookup& lookup = entry.lookup;
    const word& name = lookup.key.name;
    const std::string pad(std::max(16 - int(name.size()), 1), ' ');
    std::istringstream lines(dimensioned(entry));
    std::string line;
    std::getline(lines, line);
    os << begin << name << pad << line;
    while (std::getline(lines, line))
    {
        os << '\n' << begin << line;
    }
    os << (lookup.defaultValue == entry.value ? ";    // default\n" : ";\n");
}

void write
(
    std::ostream& os, const ReadEntry& entry, const std::string& begin
)
{
    const Lookup& lookup = entry.lookup;
    writeComment(os, entry, begin);
    // The default of this case alone, of another choice, or none
    const bool inComment =
        entry.optional || !readsBack(entry.value)
     || (!entry.isDict && !entry.condition.empty())
     || (lookup.defaultValue && !lookup.key.sample.empty());
    const std::string inner = begin + (inComment ? "// " : "");
    if (!entry.isDict)
    {
        writeValue(os, entry, inner);
        return;
    }
    os << inner << lookup.key.name << '\n' << inner << "{\n";
    write(os, entry.entries, inner + "    ");
    os << inner << "}\n";
}

void write
(
    std::ostream& os, const ReadEntries& entries, const std::string& begin
)
{
    std::size_t written = 0;
    for (const ReadEntry& entry : entries)
    {
        // Asked for, but nothing to be written: the name of a file's header
        if (entry.value.empty() && !entry.isDict)
        {
            continue;
        }
        if (written++ > 0)
        {
            const auto end = begin.find_last_not_of(' ') + 1;
            os << begin.substr(0, end) << '\n';
        }
        write(os, entry, begin);
    }
}

} // namespace


void writeHeader
(
    std::ostream& os, const std::string& title, const std::string& command
)
{
    writeWrapped(os, "//", title);
    os << "//\n";
    writeWrapped
    (
        os, "//",
        "What is marked as default may be left out, what stands in a comment"
        " be added. Written by '" + command + "'."
    );
    os << '\n';
}


void writeEntries(std::ostream& os, const ReadEntries& entries)
{
    write(os, entries, "");
}


void writeDictionary
(
    std::ostream& os, const std::string& place, const std::string& command,
    const DictionaryReader& read
)
{
    ReadEntries entries = explore("", read);
    entries.erase
    (
        std::remove_if
        (
            entries.begin(), entries.end(),
            [](const ReadEntry& entry)
            {
                const word& name = entry.lookup.key.name;
                const auto n = name.size();
                return n > 6 && name.compare(n - 6, 6, "Coeffs") == 0;
            }
        ),
        entries.end()
    );
    writeHeader(os, "All entries of " + place + '.', command);
    writeEntries(os, entries);
}

} // namespace sph
