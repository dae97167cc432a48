// Rough wall: the velocity of the material is mirrored, so that it vanishes at
// the wall, and its stress continues.
//
//     U_w = 2 U_wall - sum U V W/sum V W
//
// Adami, Hu & Adams, J. Comput. Phys. 231, 7057 (2012).
//
//     bed { type noSlip; points ((0 0 0) (0.4 0 0)); }

#include "boundaries/Wall.H"

namespace sph
{
namespace
{

class noSlip : public Wall
{
public:
    noSlip(const dictionary& dict, const word& name, const scalar spacing)
    :
        Wall(dict, name, spacing)
    {}

    vectorLanes wallVelocity(const WallPairs& pairs) const override
    {
        const vectorLanes twice{2*velocity().x(), 2*velocity().y()};
        return twice - pairs.smoothedVelocity();
    }

    WallFriction friction() const override { return {2, 2, velocity()}; }
};

static const Boundary::Add<noSlip> add
(
    "noSlip", "rough wall, velocity mirrored after Adami et al."
);

} // namespace
} // namespace sph
