// What is left of a region when others are taken away.
//
//     type     difference;
//     regions
//     (
//         block { type box;  min (0 0 0);  max (0.2 0.1 0); }
//         hole  { type circle;  centre (0.1 0.05 0);  radius 0.02; }
//     );

#include "regions/Region.H"

#include <algorithm>

namespace sph
{
namespace
{

class difference : public Region
{
    const RegionList members_;      // the first without all others

public:
    explicit difference(const dictionary& dict)
    :
        members_(readMembers(dict))
    {}

    bool inside(const vector& point) const override
    {
        return
            members_[0]->inside(point)
         && std::none_of
            (
                members_.begin() + 1, members_.end(),
                [&](const auto& member) { return member->inside(point); }
            );
    }

    Bounds bounds() const override
    {
        return members_[0]->bounds();
    }

    Frame frame() const override
    {
        return members_[0]->frame();
    }

    void crossings
    (
        const vector& origin, const vector& direction, std::vector<scalar>& t
    ) const override
    {
        for (const auto& member : members_)
        {
            member->crossings(origin, direction, t);
        }
    }
};

static const Region::Add<difference> add
(
    "difference", "the first region without the others: regions"
);

} // namespace
} // namespace sph
