// Wall with Coulomb friction: the material sticks to it as long as the shear
// traction is less than muWall times the normal one, and slips along it at
// that traction otherwise (see boundaries/WallTraction.H).
//
//     t.U_w = t.U at the surface, a line through the velocities before it
//     n.U_w = n.(2 U_wall - U~),   U~ = sum U V W/sum V W
//
// Give the coefficient, or its angle [degrees]:
//
//     bed { type CoulombWall; muWall 0.3; points ((0 0 0) (0.4 0 0)); }
//     bed { type CoulombWall; frictionAngle 17; points ((0 0 0) (0.4 0 0)); }
//
// It needs viscousScheme stressDivergence. At more friction than that of the
// material it is a rough wall.

#include "boundaries/Wall.H"

#include <cmath>

namespace sph
{
namespace
{

class CoulombWall : public Wall
{
    const scalar muWall_;

    static scalar readMuWall(const dictionary& dict)
    {
        if (dict.found({"frictionAngle", "degrees, in place of muWall", "20"}))
        {
            if (dict.found("muWall"))
            {
                dict.fail
                (
                    "muWall", "Either muWall or frictionAngle may be given"
                );
            }
            const scalar degrees = dict.get
            (
                "frictionAngle", dimless, Range::between(0, 89)
            );
            return std::tan(degrees*pi/180);
        }
        return dict.get
        (
            {"muWall", "friction coefficient of the wall", "0.38"},
            dimless, Range::nonNegative()
        );
    }

    // Of the material from the wall [m]; r points from it into the wall
    static lanes distance
    (
        const WallPairs& pairs, const WallPairs::Row& row
    )
    {
        return -(pairs.n & row.r) - pairs.depth;
    }

public:
    CoulombWall
    (
        const dictionary& dict, const word& name, const scalar spacing
    )
    :
        Wall(dict, name, spacing),
        muWall_(readMuWall(dict))
    {}

    vectorLanes wallVelocity(const WallPairs& pairs) const override
    {
        const vectorLanes U = pairs.smoothedVelocity();
        lanes d = 0;
        for (const WallPairs::Row& row : pairs)
        {
            d += pairs.invSumVW*row.VW*distance(pairs, row);
        }
        lanes dd = 0.01*spacing()*spacing();
        vectorLanes dU{0, 0};
        for (const WallPairs::Row& row : pairs)
        {
            const lanes fromMean = distance(pairs, row) - d;
            const lanes share = pairs.invSumVW*row.VW*fromMean;
            dd += share*fromMean;
            dU += share*row.U;
        }
        const vectorLanes wall{velocity().x(), velocity().y()};
        const vectorLanes Us = U - (d/dd)*dU;
        return Us - (pairs.n & (Us + U - 2.0*wall))*pairs.n;
    }

    WallFriction friction() const override { return {0, 2, velocity()}; }

    bool mirrorsStress() const override { return true; }

    label perSpacing() const override { return 2; }

    scalar muWall() const override { return muWall_; }
};

static const Boundary::Add<CoulombWall> add
(
    "CoulombWall", "wall with Coulomb friction: sticks below it, slips at it"
);

} // namespace
} // namespace sph
