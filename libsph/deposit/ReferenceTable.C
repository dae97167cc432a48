#include "deposit/ReferenceTable.H"

#include "primitives/error.H"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>

namespace sph
{

static wordList split(const std::string& line)
{
    wordList words;
    const char* const separators = ",; \t\r";
    for (std::size_t begin = 0; begin < line.size(); )
    {
        begin = line.find_first_not_of(separators, begin);
        if (begin == std::string::npos)
        {
            break;
        }
        const std::size_t end =
            std::min(line.find_first_of(separators, begin), line.size());
        words.push_back(line.substr(begin, end - begin));
        begin = end;
    }
    return words;
}

// Whether all of the words are numbers, which go to row
static bool readRow(const wordList& words, std::vector<scalar>& row)
{
    row.clear();
    for (const word& text : words)
    {
        scalar value = 0;
        const char* const end = text.data() + text.size();
        const auto result = std::from_chars(text.data(), end, value);
        if (result.ec != std::errc() || result.ptr != end)
        {
            return false;
        }
        row.push_back(value);
    }
    return true;
}

ReferenceTable::ReferenceTable(const std::filesystem::path& path)
:
    path_(path)
{
    std::ifstream is(path);
    if (!is)
    {
        throw IOError("Cannot open the reference data", path.string());
    }
    label number = 0;
    for (std::string line; std::getline(is, line); )
    {
        ++number;
        const bool comment = !line.empty() && line[0] == '#';
        const wordList words = split(comment ? line.substr(1) : line);
        std::vector<scalar> row;
        if (words.empty() || (comment && !rows_.empty()))
        {
            continue;
        }
        if (!comment && readRow(words, row) && row.size() == names_.size())
        {
            rows_.push_back(row);
            continue;
        }
        if (!rows_.empty())
        {
            throw IOError
            (
                "Expected " + std::to_string(names_.size())
              + " numbers, one a column", path.string(), number
            );
        }
        names_ = words;
    }
    if (rows_.empty())
    {
        throw IOError
        (
            "There is no row of numbers below a line that names the columns",
            path.string()
        );
    }
}

label ReferenceTable::column(const word& name) const
{
    const auto found = std::find(names_.begin(), names_.end(), name);
    if (found == names_.end())
    {
        throw Error
        (
            "There is no column " + name + " in " + path_.string()
          + "\n\nIts columns are :\n\n" + listOfWords(names_)
        );
    }
    return label(found - names_.begin());
}


bool ReferenceCurve::covers(const scalar x) const
{
    return
        points_.size() > 1 && x >= points_.begin()->first
     && x <= points_.rbegin()->first;
}

scalar ReferenceCurve::operator()(const scalar x) const
{
    // Up to two points before x and two behind it
    auto first = points_.lower_bound(x), last = first;
    for (label k = 0; k < 2; ++k)
    {
        first = first == points_.begin() ? first : std::prev(first);
        last = last == points_.end() ? last : std::next(last);
    }
    scalar y = 0;
    for (auto i = first; i != last; ++i)
    {
        scalar weight = 1;
        for (auto j = first; j != last; ++j)
        {
            weight *= i == j ? 1 : (x - j->first)/(i->first - j->first);
        }
        y += weight*i->second;
    }
    return y;
}

} // namespace sph
