#include "boundaries/Wall.H"

#include "geometry/Polyline.H"
#include "runTime/log.H"

#include <cmath>
#include <numeric>

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
    const Polyline line(dict, spacing);
    points_ = line.points();
    if (points_.size() < 2)
    {
        line.fail("A wall needs at least two points");
    }
    closed_ = points_.size() > 3
        && (points_.front() - points_.back()).norm() <= 1e-6*spacing;
    line.check("wall", closed_, 1e-6*spacing, -0.9999);
    for (label s = 0; s < segmentCount(); ++s)
    {
        tangents_.push_back((points_[s + 1] - points_[s]).normalized());
    }
    netLine_ = offset(-0.25*spacing);
    allSides_.resize(segmentCount());
    std::iota(allSides_.begin(), allSides_.end(), 0);
    nearSides_ = NearSides(points_, 3*spacing);     // the net looks 2 dx far
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
Wall::Foot Wall::foot
(
    const vector& point, const NearSides::Range& sides
) const
{
    scalar best = std::numeric_limits<scalar>::infinity();
    scalar bestSide = 0;
    Foot foot{-1, 0, best};
    for (const label s : sides)
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

Wall::Foot Wall::foot(const vector& point) const
{
    const label* const first = allSides_.data();
    return foot(point, {first, first + allSides_.size()});
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
