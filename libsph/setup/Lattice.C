#include "setup/Lattice.H"

#include <cmath>

namespace sph
{

Lattice::Lattice(const dictionary& dict)
:
    spacing_
    (
        dict.get
        (
            {"spacing", "distance between particles, dx", "0.01"},
            dimLength, Range::positive()
        )
    ),
    type_
    (
        dict.getChoiceOrDefault
        (
            {"lattice", "how the particles are laid"}, "square",
            {"square", "hexagonal"}
        )
    ),
    jitter_
    (
        dict.getOrDefault
        (
            {"jitter", "greatest random shift in x and y, over dx"}, 0,
            dimless, Range{0, 0.5, true, false}
        )
    ),
    random_
    (
        dict.getOrDefault<label>({"seed", "random sequence"}, 0)
    )
{
    const Key origin
    (
        "origin", "one lattice for all regions; else each has its own",
        "(0 0 0)"
    );
    if (dict.found(origin))
    {
        origin_ = dict.getVector(origin, dimLength);
    }
}

std::vector<vector> Lattice::points(const Region& region) const
{
    // Both cells have the area dx^2
    const bool hexagonal = type_ == "hexagonal";
    const scalar dx = hexagonal ? spacing_*std::sqrt(2/std::sqrt(3)) : spacing_;
    const scalar dy = spacing_*spacing_/dx;

    Region::Frame frame = region.frame();
    frame.origin = origin_.value_or(frame.origin);

    const Region::Bounds bounds = region.bounds();
    Region::Bounds local;
    for (const auto corner : {0, 1, 2, 3})
    {
        local.extend
        (
            frame.toLocal(bounds.corner(Region::Bounds::CornerType(corner)))
        );
    }
    std::vector<vector> points;
    const auto first = [](scalar x) { return std::int64_t(std::floor(x)) - 1; };
    const auto last = [](scalar x) { return std::int64_t(std::ceil(x)); };
    for
    (
        auto row = first(local.min().y()/dy);
        row <= last(local.max().y()/dy);
        ++row
    )
    {
        const scalar shift = !hexagonal ? 0.5 : row % 2 == 0 ? 0.25 : 0.75;
        for
        (
            auto column = first(local.min().x()/dx);
            column <= last(local.max().x()/dx);
            ++column
        )
        {
            const vector point =
                frame.toGlobal({(column + shift)*dx, (row + 0.5)*dy});
            if (region.owns(point, 1e-6*spacing_))
            {
                points.push_back(point);
            }
        }
    }
    return points;
}

void Lattice::shake
(
    std::vector<vector>& points,
    const std::function<bool(const vector&)>& allowed
)
{
    if (jitter_ == 0)
    {
        return;
    }
    // From -1 to 1, on every machine the same
    const auto uniform = [this]()
    {
        return std::ldexp(scalar(random_() >> 11), -52) - 1;
    };
    for (vector& point : points)
    {
        const scalar dx = jitter_*spacing_*uniform();
        const scalar dy = jitter_*spacing_*uniform();
        const vector moved = point + vector(dx, dy);
        if (allowed(moved))
        {
            point = moved;
        }
    }
}

} // namespace sph
