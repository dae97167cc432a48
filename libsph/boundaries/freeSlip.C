// Smooth wall: only the normal velocity of the material is mirrored, and its
// shear stress changes sign.
//
//     U_w = U~ - 2 n n.(U~ - U_wall),   U~ = sum U V W/sum V W
//
// Adami, Hu & Adams, J. Comput. Phys. 231, 7057 (2012). Its particles stand two
// to a spacing along the wall, see Wall.
//
//     side { type freeSlip; points ((0 0.2 0) (0 0 0)); }

#include "boundaries/Wall.H"

namespace sph
{
namespace
{

class freeSlip : public Wall
{
public:
    freeSlip(const dictionary& dict, const word& name, const scalar spacing)
    :
        Wall(dict, name, spacing)
    {}

    vectorLanes wallVelocity(const WallPairs& pairs) const override
    {
        const vectorLanes U = pairs.smoothedVelocity();
        const vectorLanes wall{velocity().x(), velocity().y()};
        return U - (2.0*(pairs.n & (U - wall)))*pairs.n;
    }

    WallFriction friction() const override { return {0, 2, velocity()}; }

    bool mirrorsStress() const override { return true; }

    label perSpacing() const override { return 2; }
};

static const Boundary::Add<freeSlip> add
(
    "freeSlip", "smooth wall, normal velocity mirrored"
);

} // namespace
} // namespace sph
