#include "regions/Region.H"

#include <algorithm>

namespace sph
{

scalar Region::area() const
{
    constexpr label nChords = 4096;
    const Bounds box = bounds();
    const vector across(1, 0);
    const scalar dy = box.sizes().y()/nChords;

    scalar length = 0;
    std::vector<scalar> t;
    for (label i = 0; i < nChords; ++i)
    {
        const vector start(box.min().x(), box.min().y() + (i + 0.5)*dy);
        t.clear();
        crossings(start, across, t);
        std::sort(t.begin(), t.end());
        for (std::size_t k = 1; k < t.size(); ++k)
        {
            if (inside(start + 0.5*(t[k - 1] + t[k])*across))
            {
                length += t[k] - t[k - 1];
            }
        }
    }
    return length*dy;
}

static const Key regionsKey
(
    "regions", "two or more regions, each with a name",
    "(\n"
    "    foot { type box; min (0 0 0); max (0.2 0.05 0); }\n"
    "    head { type circle; centre (0.1 0.05 0); radius 0.04; }\n"
    ")"
);

RegionList readMembers(const dictionary& dict)
{
    RegionList members;
    for (const auto& [name, memberDict] : dict.dictList(regionsKey))
    {
        members.push_back(Region::New(*memberDict));
    }
    if (members.size() < 2)
    {
        dict.fail
        (
            "regions",
            "At least two regions are needed here, there "
          + std::string(members.empty() ? "is none" : "is one")
        );
    }
    return members;
}

scalar distanceToBorder
(
    const std::vector<const Region*>& regions,
    const vector& point, const vector& direction, const scalar gap
)
{
    std::vector<scalar> t;
    for (const Region* region : regions)
    {
        region->crossings(point, direction, t);
    }
    std::sort(t.begin(), t.end());

    const auto insideAny = [&](const vector& x)
    {
        return std::any_of
        (
            regions.begin(), regions.end(),
            [&](const Region* region) { return region->inside(x); }
        );
    };

    scalar last = 0;
    scalar border = 0;
    for (const scalar next : t)
    {
        if (next <= 0)
        {
            continue;
        }
        if (insideAny(point + 0.5*(last + next)*direction))
        {
            border = next;
        }
        else if (next - border > gap)
        {
            break;
        }
        last = next;
    }
    return border;
}

} // namespace sph
