#include "deposit/selectTimes.H"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace sph
{

// Times are written with six digits
static constexpr scalar relativeTolerance = 1e-5;


static scalar number(const std::string& text, const std::string& list)
{
    std::istringstream is(text);
    scalar value;
    std::string rest;
    if (!(is >> value) || is >> rest)
    {
        throw Error
        (
            "'" + text + "' in the list of times '" + list + "' is no time"
            "\n\nValid are numbers and ranges: 0.05,0.1   0:1   :0.5   0.5:"
        );
    }
    return value;
}


// The lowest and highest value that an item stands for
static std::pair<scalar, scalar> bounds
(
    const std::string& item, const std::string& list
)
{
    const scalar infinite = std::numeric_limits<scalar>::infinity();
    const auto colon = item.find(':');
    if (colon == std::string::npos)
    {
        const scalar value = number(item, list);
        const scalar margin = relativeTolerance*std::abs(value) + 1e-12;
        return {value - margin, value + margin};
    }
    const std::string from = item.substr(0, colon);
    const std::string to = item.substr(colon + 1);
    const scalar margin = 1e-12;
    return
    {
        (from.empty() ? -infinite : number(from, list)) - margin,
        (to.empty() ? infinite : number(to, list)) + margin
    };
}


std::vector<Time::Instant> selectTimes
(
    const std::vector<Time::Instant>& written, const std::string& list
)
{
    wordList names;
    for (const Time::Instant& time : written)
    {
        names.push_back(time.name);
    }

    std::string blanks = list;
    std::replace(blanks.begin(), blanks.end(), ',', ' ');
    std::istringstream items(blanks);
    std::vector<bool> selected(written.size(), false);
    bool any = false;
    for (std::string item; items >> item; )
    {
        const auto [low, high] = bounds(item, list);
        bool found = false;
        for (std::size_t i = 0; i < written.size(); ++i)
        {
            if (low <= written[i].value && written[i].value <= high)
            {
                selected[i] = found = any = true;
            }
        }
        if (!found)
        {
            throw Error
            (
                "No time " + item + " was written\n\nWritten times :\n\n"
              + listOfWords(names)
            );
        }
    }
    if (!any)
    {
        throw Error("The list of times '" + list + "' is empty");
    }

    std::vector<Time::Instant> result;
    for (std::size_t i = 0; i < written.size(); ++i)
    {
        if (selected[i])
        {
            result.push_back(written[i]);
        }
    }
    return result;
}

} // namespace sph
