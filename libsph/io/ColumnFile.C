#include "io/ColumnFile.H"

#include "primitives/error.H"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>

namespace sph
{

namespace
{

std::string trimmed(const std::string& text)
{
    const char* const blanks = " \t\r";
    const std::size_t begin = text.find_first_not_of(blanks);
    if (begin == std::string::npos)
    {
        return "";
    }
    return text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
}

std::string unquoted(const std::string& text)
{
    const bool quoted =
        text.size() > 1 && text.front() == '"' && text.back() == '"';
    return quoted ? text.substr(1, text.size() - 2) : text;
}

wordList split(const std::string& text)
{
    const std::string line = trimmed(text);
    const bool blanks = line.find_first_of(";,") == std::string::npos;
    const char* const separators =
        blanks ? " \t" : line.find(';') != std::string::npos ? ";" : ",";
    wordList words;
    for (std::size_t begin = 0; begin < line.size(); )
    {
        const std::size_t end =
            std::min(line.find_first_of(separators, begin), line.size());
        if (!blanks || end > begin)
        {
            words.push_back(unquoted(trimmed(line.substr(begin, end - begin))));
        }
        begin = end + 1;
    }
    return words;
}

bool readNumber(const word& text, scalar& value)
{
    const char* const begin = text.data() + (text[0] == '+');
    const char* const end = text.data() + text.size();
    const auto result = std::from_chars(begin, end, value);
    return result.ec == std::errc() && result.ptr == end;
}

bool isNumber(const word& text)
{
    scalar ignored = 0;
    return readNumber(text, ignored);
}

// What the columns of a file that does not say so are called
wordList defaultNames(const std::size_t count)
{
    wordList names{"x", "y", "z"};
    names.resize(std::min<std::size_t>(count, 3));
    for (std::size_t k = 4; k <= count; ++k)
    {
        names.push_back(std::to_string(k));
    }
    return names;
}

} // namespace


ColumnFile::ColumnFile(const std::filesystem::path& path)
:
    path_(path)
{
    std::ifstream is(path);
    if (!is || std::filesystem::is_directory(path))
    {
        throw IOError("Cannot open the file", path.string());
    }
    label number = 0;
    bool namesAreComment = true;
    for (std::string line; std::getline(is, line); )
    {
        if (++number == 1 && line.rfind("\xEF\xBB\xBF", 0) == 0)
        {
            line.erase(0, 3);       // the mark that spreadsheets write
        }
        const bool comment = !line.empty() && line[0] == '#';
        const wordList words = split(comment ? line.substr(1) : line);
        if (words.empty() || (comment && !rows_.empty()))
        {
            continue;
        }
        const bool names =
            comment
         || (
                rows_.empty()
             && std::none_of(words.begin(), words.end(), isNumber)
            );
        if (names)
        {
            names_ = words;
            namesAreComment = comment;
        }
        else
        {
            addRow(words, number, namesAreComment);
        }
    }
    if (rows_.empty())
    {
        throw IOError("There is no row of numbers in the file", path.string());
    }
}

void ColumnFile::addRow
(
    const wordList& words, const label line, const bool namesAreComment
)
{
    if (rows_.empty() && namesAreComment && names_.size() != words.size())
    {
        names_ = defaultNames(words.size());
    }
    if (words.size() != names_.size())
    {
        throw IOError
        (
            "Expected " + std::to_string(names_.size())
          + " numbers, one a column, found " + std::to_string(words.size()),
            path_.string(), line
        );
    }
    std::vector<scalar> row(words.size());
    for (std::size_t k = 0; k < words.size(); ++k)
    {
        if (!readNumber(words[k], row[k]) || !std::isfinite(row[k]))
        {
            throw IOError
            (
                "Expected a number in column " + names_[k] + ", found '"
              + words[k] + '\'',
                path_.string(), line
            );
        }
    }
    rows_.push_back(row);
    lines_.push_back(line);
}

label ColumnFile::column(const word& name) const
{
    const auto found = std::find(names_.begin(), names_.end(), name);
    if (found == names_.end())
    {
        throw IOError
        (
            "There is no column " + name + " in the file\n\n"
            "Its columns are :\n\n" + listOfWords(names_),
            path_.string()
        );
    }
    return label(found - names_.begin());
}

} // namespace sph
