// What the sides of a polyline must not do.
#include "geometry/Polyline.H"

#include <algorithm>
#include <numeric>
#include <optional>

namespace sph
{

namespace
{

// Twice the area of the triangle abc, positive if counterclockwise
scalar turn(const vector& a, const vector& b, const vector& c)
{
    return (b.x() - a.x())*(c.y() - a.y()) - (b.y() - a.y())*(c.x() - a.x());
}

// True if c lies in the upright box around a and b
bool between(const vector& a, const vector& b, const vector& c)
{
    return
        (c.array() >= a.array().min(b.array())).all()
     && (c.array() <= a.array().max(b.array())).all();
}

struct Side
{
    vector a;
    vector b;

    scalar left() const { return std::min(a.x(), b.x()); }
    scalar right() const { return std::max(a.x(), b.x()); }

    bool meets(const Side& other) const
    {
        const vector& c = other.a;
        const vector& d = other.b;
        const scalar abc = turn(a, b, c), abd = turn(a, b, d);
        const scalar cda = turn(c, d, a), cdb = turn(c, d, b);
        return
            (abc*abd < 0 && cda*cdb < 0)
         || (abc == 0 && between(a, b, c)) || (abd == 0 && between(a, b, d))
         || (cda == 0 && between(c, d, a)) || (cdb == 0 && between(c, d, b));
    }
};

// Two sides that have no end in common and meet, the lower numbers first
std::optional<std::pair<label, label>> meeting
(
    const std::vector<Side>& sides, const bool closed
)
{
    const label n = label(sides.size());
    std::vector<label> fromLeft(n);
    std::iota(fromLeft.begin(), fromLeft.end(), 0);
    std::stable_sort
    (
        fromLeft.begin(), fromLeft.end(),
        [&](const label i, const label j)
        {
            return sides[i].left() < sides[j].left();
        }
    );
    std::optional<std::pair<label, label>> first;
    for (label k = 0; k < n; ++k)
    {
        const Side& side = sides[fromLeft[k]];
        for
        (
            label l = k + 1;
            l < n && sides[fromLeft[l]].left() <= side.right();
            ++l
        )
        {
            const std::pair<label, label> pair =
                std::minmax(fromLeft[k], fromLeft[l]);
            const label apart = pair.second - pair.first;
            const bool neighbours = apart == 1 || (closed && apart == n - 1);
            if
            (
                !neighbours && (!first || pair < *first)
             && side.meets(sides[fromLeft[l]])
            )
            {
                first = pair;
            }
        }
    }
    return first;
}

} // namespace


void Polyline::check
(
    const word& kind, const bool closed, const scalar least,
    const scalar leastCosine
) const
{
    const label n = label(points_.size());
    const bool joined =
        closed && n > 2 && (points_.back() - points_.front()).norm() > least;
    std::vector<Side> sides;
    for (label i = 0; i + 1 < n + joined; ++i)
    {
        const label next = (i + 1) % n;
        sides.push_back({points_[i], points_[next]});
        if ((points_[next] - points_[i]).norm() <= least)
        {
            fail
            (
                "Points " + std::to_string(i) + " and " + std::to_string(next)
              + " of the " + kind + " are the same, " + asText(points_[i]), next
            );
        }
    }
    const label count = label(sides.size());
    for (label i = closed ? 0 : 1; i < count; ++i)
    {
        const Side& before = sides[(i + count - 1) % count];
        const vector turned = (sides[i].b - sides[i].a).normalized();
        if ((before.b - before.a).normalized().dot(turned) < leastCosine)
        {
            fail
            (
                "The " + kind + " folds back on itself at point "
              + std::to_string(i) + ", " + asText(points_[i]), i
            );
        }
    }
    if (const auto pair = meeting(sides, closed))
    {
        const auto [i, j] = *pair;
        fail
        (
            "The " + kind + " intersects itself: the side after point "
          + std::to_string(i) + " meets the side after point "
          + std::to_string(j) + " (points count from 0)\n\nThey begin at "
          + asText(points_[i]) + " and " + asText(points_[j]), i
        );
    }
}

} // namespace sph
