#include "boundaries/Wall.H"

#include "runTime/log.H"

#include <cmath>

namespace sph
{

static Motion readMotion(const dictionary& dict)
{
    return
        dict.found({"motion", "motion of the wall itself: a gate", "{}"})
      ? Motion(dict.subDict("motion")) : Motion();
}

Wall::Wall(const dictionary& dict, const word& name, const scalar spacing)
:
    Boundary(name, spacing),
    points_
    (
        dict.get<std::vector<vector>>
        ({
            "points", "polyline [m] with the material on its left-hand side",
            "((0 0 0) (0.4 0 0))"
        })
    ),
    layers_
    (
        dict.getLabelOrDefault
        (
            {"layers", "rows of wall particles behind it"}, 3, Range{1}
        )
    ),
    velocity_
    (
        dict.getVectorOrDefault
        (
            {"velocity", "velocity of its surface, as of a belt"},
            vector::Zero(), dimVelocity
        )
    ),
    motion_(readMotion(dict))
{
    if (points_.size() < 2)
    {
        dict.fail("points", "A wall needs at least two points");
    }
    for (label s = 0; s < segmentCount(); ++s)
    {
        if (length(s) < 1e-6*spacing)
        {
            dict.fail("points", "Two points of the wall coincide");
        }
        tangents_.push_back((points_[s + 1] - points_[s]).normalized());
    }
    closed_ = points_.size() > 3
        && (points_.front() - points_.back()).norm() < 1e-6*spacing;
    for (label v = 0; v <= segmentCount(); ++v)
    {
        const auto [before, after] = corner(v);
        if (tangent(before).dot(tangent(after)) < -0.9999)
        {
            dict.fail
            (
                "points", "The wall turns back on itself at ("
              + std::to_string(points_[v].x()) + ' '
              + std::to_string(points_[v].y()) + " 0)"
            );
        }
    }
    netLine_ = offset(-0.25*spacing);
}

void Wall::moveTo(const scalar time)
{
    displacement_ = motion_.displacement(time);
    motionVelocity_ = motion_.velocity(time);
}

scalar Wall::length(const label segment) const
{
    return (points_[segment + 1] - points_[segment]).norm();
}

// To the left
vector Wall::normal(const label segment) const
{
    const vector& t = tangent(segment);
    return {-t.y(), t.x()};
}

Wall::Corner Wall::corner(const label point) const
{
    const label n = segmentCount();
    return
    {
        point > 0 ? point - 1 : (closed_ ? n - 1 : 0),
        point < n ? point : (closed_ ? 0 : n - 1)
    };
}

scalar Wall::turn(const label point) const
{
    const auto [before, after] = corner(point);
    return normal(before).dot(tangent(after));
}

// The nearest one; its side is that of the nearer segment, at a corner that of
// the segment which the point faces most
Wall::Foot Wall::foot(const vector& point) const
{
    scalar best = std::numeric_limits<scalar>::infinity();
    scalar bestSide = 0;
    Foot foot{-1, 0, best};
    for (label s = 0; s < segmentCount(); ++s)
    {
        const scalar length = this->length(s);
        const vector& t = tangent(s);
        const vector d = point - points_[s];
        const scalar along = d.dot(t);
        const bool first = s == 0 && !closed_;
        const bool last = s == segmentCount() - 1 && !closed_;
        if ((first && along < 0) || (last && along > length))
        {
            continue;
        }
        const scalar clamped = std::min(std::max(along, 0.0), length);
        const scalar magnitude = (d - clamped*t).norm();
        const scalar side = d.dot(normal(s));
        const bool tie = std::abs(magnitude - best) <= 1e-12*length;
        if
        (
            (!tie && magnitude < best)
         || (tie && std::abs(side) > std::abs(bestSide))
        )
        {
            best = std::min(best, magnitude);
            bestSide = side;
            foot = {s, along, bestSide < 0 ? -best : best};
        }
    }
    return foot;
}

scalar Wall::distance(const vector& point) const
{
    return foot(point - displacement_).distance;
}

void Wall::check(const Particles&, const scalar reach) const
{
    // Rows lie (l + 1/2) dx deep; material comes as near as dx/4, and the skin
    // of the lists is about as wide
    const label needed = label(std::ceil(reach/spacing() - 1));
    if (layers_ < needed)
    {
        warning
        (
            "Wall " + name() + " has " + std::to_string(layers_)
          + " layers of particles, but the kernel reaches "
          + std::to_string(needed) + ": material near it sees a void.\n"
            "Give layers " + std::to_string(needed) + " in constant/boundary"
            " and run setParticles again."
        );
    }
}

} // namespace sph
