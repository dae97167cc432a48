// A polygon, convex or not.
//
//     type polygon;  points ((0 0 0) (0.2 0 0) (0.1 0.1 0));
//
// points   three or more corners in order, either way round; the last joins
//          the first; sides must not meet except at common corners [m]

#include "regions/Outline.H"

#include <algorithm>

namespace sph
{
namespace
{

class polygon : public Outline
{
    // Twice the area of the triangle abc, positive if counterclockwise
    static scalar turn(const vector& a, const vector& b, const vector& c)
    {
        return
            (b.x() - a.x())*(c.y() - a.y()) - (b.y() - a.y())*(c.x() - a.x());
    }

    // True if c lies in the upright box around a and b
    static bool between(const vector& a, const vector& b, const vector& c)
    {
        return
            (c.array() >= a.array().min(b.array())).all()
         && (c.array() <= a.array().max(b.array())).all();
    }

    static bool intersect
    (
        const vector& a, const vector& b, const vector& c, const vector& d
    )
    {
        const scalar abc = turn(a, b, c), abd = turn(a, b, d);
        const scalar cda = turn(c, d, a), cdb = turn(c, d, b);
        return
            (abc*abd < 0 && cda*cdb < 0)
         || (abc == 0 && between(a, b, c)) || (abd == 0 && between(a, b, d))
         || (cda == 0 && between(c, d, a)) || (cdb == 0 && between(c, d, b));
    }

    // Sides i = (i, i+1) and i+1 share a corner and may only fold back
    void checkCorner(const dictionary& dict, const std::size_t i) const
    {
        const std::size_t n = points().size();
        const vector& a = points()[i];
        const vector& b = points()[(i + 1) % n];
        const vector& c = points()[(i + 2) % n];
        if (a == b)
        {
            dict.fail
            (
                "points", "Points " + std::to_string(i) + " and "
              + std::to_string((i + 1) % n) + " of the polygon are the same"
            );
        }
        if (turn(a, b, c) == 0 && (b - a).dot(c - b) < 0)
        {
            dict.fail
            (
                "points", "The polygon folds back on itself at point "
              + std::to_string((i + 1) % n)
            );
        }
    }

    void checkSides(const dictionary& dict) const
    {
        const std::size_t n = points().size();
        for (std::size_t i = 0; i < n; ++i)
        {
            const std::size_t end = i == 0 ? n - 1 : n;
            for (std::size_t j = i + 2; j < end; ++j)
            {
                if
                (
                    intersect
                    (
                        points()[i], points()[i + 1],
                        points()[j], points()[(j + 1) % n]
                    )
                )
                {
                    dict.fail
                    (
                        "points",
                        "The polygon intersects itself: the side after point "
                      + std::to_string(i) + " meets the side after point "
                      + std::to_string(j) + " (points count from 0)"
                    );
                }
            }
        }
    }

public:
    explicit polygon(const dictionary& dict)
    :
        Outline
        (
            dict.get<std::vector<vector>>
            ({
                "points", "corners [m] in order; the last joins the first",
                "((0 0 0) (0.2 0 0) (0.1 0.1 0))"
            })
        )
    {
        if (points().size() < 3)
        {
            dict.fail
            (
                "points", "A polygon needs at least 3 points, not "
              + std::to_string(points().size())
            );
        }
        for (std::size_t i = 0; i < points().size(); ++i)
        {
            checkCorner(dict, i);
        }
        checkSides(dict);
    }
};

static const Region::Add<polygon> add
(
    "polygon", "polygon, convex or not: points"
);

} // namespace
} // namespace sph
