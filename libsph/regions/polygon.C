// A polygon, convex or not.
//
//     type polygon;  points ((0 0 0) (0.2 0 0) (0.1 0.1 0));
//     type polygon;  geometry { file "constant/geometry/ground.csv"; }
//
// points   three or more corners in order, either way round; the last joins
//          the first; sides must not meet except at common corners [m]
// geometry the same from a file, see geometry/Polyline.H

#include "geometry/Polyline.H"
#include "regions/Outline.H"

namespace sph
{
namespace
{

class polygon : public Outline
{
    // The first corner is not repeated
    static std::vector<vector> corners(const dictionary& dict)
    {
        const Polyline line(dict, 0);
        std::vector<vector> points = line.points();
        const bool closed = points.size() > 1 && points.front() == points.back();
        if (!closed && !line.mayBeJoined())
        {
            line.fail
            (
                "The outline is open, from " + asText(points.front()) + " to "
              + asText(points.back()) + ": the surface has a gap there"
            );
        }
        if (closed)
        {
            points.pop_back();
        }
        if (points.size() < 3)
        {
            line.fail
            (
                "A polygon needs at least 3 points, not "
              + std::to_string(points.size())
            );
        }
        line.check("polygon", true, 0, -1 + 1e-9);
        return points;
    }

public:
    explicit polygon(const dictionary& dict)
    :
        Outline(corners(dict))
    {}
};

static const Region::Add<polygon> add
(
    "polygon", "polygon, convex or not: points, or geometry of a file"
);

} // namespace
} // namespace sph
