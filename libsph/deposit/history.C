#include "deposit/history.H"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sph
{

scalar settlingTime
(
    const std::vector<scalar>& times,
    const std::vector<scalar>& values,
    const scalar tolerance
)
{
    scalar settled = std::numeric_limits<scalar>::quiet_NaN();
    if (values.empty())
    {
        return settled;
    }
    scalar low = values.back(), high = values.back();
    for (label i = label(values.size()) - 2; i >= 0; --i)
    {
        low = std::min(low, values[i]);
        high = std::max(high, values[i]);
        if (!(high - low <= tolerance) || values[i] != values[i])
        {
            break;
        }
        settled = times[i];
    }
    return settled;
}


RecentValues::RecentValues(const scalar window)
:
    window_(window)
{}


void RecentValues::add(const scalar time, const scalar value)
{
    values_.emplace_back(time, value);

    // The oldest value is the last one that is as old as the window
    while (values_.size() > 1 && time - values_[1].first >= window_)
    {
        values_.pop_front();
    }
}


std::vector<scalar> RecentValues::list() const
{
    std::vector<scalar> list;
    for (const auto& [time, value] : values_)
    {
        list.insert(list.end(), {time, std::isfinite(value) ? value : 1e300});
    }
    return list;
}


void RecentValues::set(const std::vector<scalar>& list)
{
    values_.clear();
    for (std::size_t i = 0; i + 1 < list.size(); i += 2)
    {
        values_.emplace_back(list[i], list[i + 1]);
    }
}


scalar RecentValues::change() const
{
    const scalar infinite = std::numeric_limits<scalar>::infinity();
    if
    (
        values_.empty()
     || values_.back().first - values_.front().first < window_
    )
    {
        return infinite;
    }
    scalar low = infinite, high = -infinite;
    for (const auto& [time, value] : values_)
    {
        if (value != value)
        {
            return infinite;
        }
        low = std::min(low, value);
        high = std::max(high, value);
    }
    return high - low;
}

} // namespace sph
