#include "geometry/simplified.H"

#include <Eigen/Geometry>

#include <algorithm>

namespace sph
{

// Distance of p from the side between a and b
static scalar departure(const vector& p, const vector& a, const vector& b)
{
    const vector side = b - a;
    const scalar square = side.squaredNorm();
    const scalar along =
        square > 0 ? std::clamp((p - a).dot(side)/square, 0.0, 1.0) : 0;
    return (p - a - along*side).norm();
}

// Of all points between two from the side that joins these
static scalar departure
(
    const std::vector<vector>& points, const label begin, const label end
)
{
    scalar greatest = 0;
    for (label i = begin + 1; i < end; ++i)
    {
        const scalar off = departure(points[i], points[begin], points[end]);
        greatest = std::max(greatest, off);
    }
    return greatest;
}

// Without points that stand on the straight line between those on either side
static std::vector<label> straightened(const std::vector<vector>& points)
{
    Eigen::AlignedBox2d extent;
    for (const vector& point : points)
    {
        extent.extend(point);
    }
    const scalar tolerance = 1e-6*extent.diagonal().norm();
    std::vector<label> left;
    for (label i = 0; i < label(points.size()); ++i)
    {
        while
        (
            left.size() > 1
         && departure
            (
                points[left.back()], points[left[left.size() - 2]], points[i]
            ) < tolerance
        )
        {
            left.pop_back();
        }
        left.push_back(i);
    }
    return left;
}

std::vector<label> simplified
(
    const std::vector<vector>& points, const scalar shortest
)
{
    const std::vector<label> bends = straightened(points);
    std::vector<label> left;
    for (std::size_t k = 0; k < bends.size(); ++k)
    {
        const label i = bends[k];
        const bool last = k + 1 == bends.size();
        const auto tooShort = [&]()
        {
            return
                !left.empty()
             && (points[i] - points[left.back()]).norm() < shortest;
        };
        // Whether the point before goes, not this one
        const auto goesBefore = [&]()
        {
            return
                left.size() > 1
             && (
                    last
                 || departure(points, left[left.size() - 2], i)
                  < departure
                    (
                        points[i], points[left.back()], points[bends[k + 1]]
                    )
                );
        };
        while (tooShort() && goesBefore())
        {
            left.pop_back();
        }
        if (last || !tooShort())
        {
            left.push_back(i);
        }
    }
    return left;
}

scalar greatestDeparture
(
    const std::vector<vector>& points, const std::vector<label>& left
)
{
    scalar greatest = 0;
    for (std::size_t k = 1; k < left.size(); ++k)
    {
        const scalar off = departure(points, left[k - 1], left[k]);
        greatest = std::max(greatest, off);
    }
    return greatest;
}

} // namespace sph
