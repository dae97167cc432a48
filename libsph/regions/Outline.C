#include "regions/Outline.H"

#include <cmath>

namespace sph
{

static scalar cross(const vector& a, const vector& b)
{
    return a.x()*b.y() - a.y()*b.x();
}

Outline::Outline(std::vector<vector> points)
:
    points_(std::move(points))
{}

bool Outline::inside(const vector& point) const
{
    // Even-odd rule: edges to the right of the point, lower end included
    bool isInside = false;
    for (std::size_t i = 0; i < points_.size(); ++i)
    {
        const vector& a = points_[i];
        const vector& b = points_[(i + 1) % points_.size()];
        if
        (
            (a.y() > point.y()) != (b.y() > point.y())
         && point.x()
          < a.x() + (point.y() - a.y())/(b.y() - a.y())*(b.x() - a.x())
        )
        {
            isInside = !isInside;
        }
    }
    return isInside;
}

Region::Bounds Outline::bounds() const
{
    Bounds box;
    for (const vector& point : points_)
    {
        box.extend(point);
    }
    return box;
}

scalar Outline::area() const
{
    scalar twice = 0;
    for (std::size_t i = 0; i < points_.size(); ++i)
    {
        twice += cross
        (
            points_[i] - points_[0],
            points_[(i + 1) % points_.size()] - points_[0]
        );
    }
    return 0.5*std::abs(twice);
}

void Outline::crossings
(
    const vector& origin, const vector& direction, std::vector<scalar>& t
) const
{
    for (std::size_t i = 0; i < points_.size(); ++i)
    {
        const vector& a = points_[i];
        const vector& b = points_[(i + 1) % points_.size()];
        const scalar sideA = cross(direction, a - origin);
        const scalar sideB = cross(direction, b - origin);
        if ((sideA > 0) != (sideB > 0))
        {
            const vector x = a + sideA/(sideA - sideB)*(b - a);
            t.push_back
            (
                (x - origin).dot(direction)/direction.squaredNorm()
            );
        }
    }
}

} // namespace sph
