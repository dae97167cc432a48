// All that lies in any of several regions.
//
//     type     union;
//     regions
//     (
//         foot { type box;  min (0 0 0);  max (0.2 0.1 0); }
//         head { type circle;  centre (0.1 0.1 0);  radius 0.1; }
//     );

#include "regions/Region.H"

#include <algorithm>

namespace sph
{
namespace
{

// The keyword union is taken by the language
class unionOf : public Region
{
    const RegionList members_;

public:
    explicit unionOf(const dictionary& dict)
    :
        members_(readMembers(dict))
    {}

    bool inside(const vector& point) const override
    {
        return std::any_of
        (
            members_.begin(), members_.end(),
            [&](const auto& member) { return member->inside(point); }
        );
    }

    Bounds bounds() const override
    {
        Bounds box;
        for (const auto& member : members_)
        {
            box.extend(member->bounds());
        }
        return box;
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

static const Region::Add<unionOf> add
(
    "union", "what lies in any of the regions: regions"
);

} // namespace
} // namespace sph
