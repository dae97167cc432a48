#include "boundaries/NearSides.H"

#include <Eigen/Geometry>

#include <cmath>
#include <functional>

namespace sph
{

namespace
{

// Of a point from the side between a and b
scalar distance(const vector& point, const vector& a, const vector& b)
{
    const vector side = b - a;
    const scalar along = (point - a).dot(side)/side.squaredNorm();
    return (point - a - std::min(std::max(along, 0.0), 1.0)*side).norm();
}

} // namespace


NearSides::NearSides(const std::vector<vector>& points, const scalar reach)
{
    Eigen::AlignedBox2d bounds;
    for (const vector& point : points)
    {
        bounds.extend(point);
    }
    origin_ = bounds.min() - vector::Constant(reach);
    const vector size = bounds.sizes() + vector::Constant(2*reach);
    // As wide as reach, unless that were more than a million cells
    width_ = std::max(reach, std::sqrt(size.prod()/1e6));
    nx_ = label(size.x()/width_) + 1;
    ny_ = label(size.y()/width_) + 1;

    const auto cellsNear = [&](const std::function<void(label, label)>& visit)
    {
        for (label s = 0; s + 1 < label(points.size()); ++s)
        {
            Eigen::AlignedBox2d box(points[s]);
            box.extend(points[s + 1]);
            const vector first =
                (box.min() - origin_ - vector::Constant(reach))/width_;
            const vector last =
                (box.max() - origin_ + vector::Constant(reach))/width_;
            for (label y = label(first.y()); y <= label(last.y()); ++y)
            {
                for (label x = label(first.x()); x <= label(last.x()); ++x)
                {
                    const vector centre =
                        origin_ + width_*vector(x + 0.5, y + 0.5);
                    // The corners of a cell are 0.7072 of its width away
                    const bool near =
                        x < nx_ && y < ny_
                     && distance(centre, points[s], points[s + 1])
                      < reach + 0.7072*width_;
                    if (near)
                    {
                        visit(y*nx_ + x, s);
                    }
                }
            }
        }
    };

    begin_.assign(nx_*ny_ + 1, 0);
    cellsNear([&](const label cell, label) { ++begin_[cell + 1]; });
    for (label cell = 0; cell < nx_*ny_; ++cell)
    {
        begin_[cell + 1] += begin_[cell];
    }
    sides_.resize(begin_.back());
    std::vector<label> next(begin_.begin(), begin_.end() - 1);
    cellsNear
    (
        [&](const label cell, const label s) { sides_[next[cell]++] = s; }
    );
}

} // namespace sph
