#include "deposit/ReferenceCurve.H"

#include <iterator>

namespace sph
{

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
