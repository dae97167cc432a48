// The paper's rough wall: each dummy particle b moves so that the velocity
// that a particle a at distance d_a sees changes sign at the wall, within a
// limit near it.
//
//     U_ab = beta U_a,   beta = min(betaMax, 1 + d_b/d_a)         (21)-(23)
//     U_b  = sum (1 - beta) U_a V W/sum V W
//
// relative to the wall. Morris, Fox & Zhu, J. Comput. Phys. 136, 214 (1997);
// Salehizadeh & Shafiei, Granular Matter 21:32 (2019). One velocity a dummy:
// the mean over the particles that it faces.
//
//     bed { type Morris; betaMax 1.8; points ((0 0 0) (0.4 0 0)); }

#include "boundaries/Wall.H"

namespace sph
{
namespace
{

class Morris : public Wall
{
    const scalar betaMax_;

public:
    Morris(const dictionary& dict, const word& name, const scalar spacing)
    :
        Wall(dict, name, spacing),
        betaMax_
        (
            dict.getOrDefault
            (
                {"betaMax", "greatest beta, Eq. 23"}, 1.8,
                dimless, Range::between(1, 10)
            )
        )
    {}

    vectorLanes wallVelocity(const WallPairs& pairs) const override
    {
        const vectorLanes wall{velocity().x(), velocity().y()};
        vectorLanes sum{0, 0};
        for (const WallPairs::Row& row : pairs)
        {
            // r_ab points from the material into the wall: d_a + d_b
            const lanes both = -(pairs.n & row.r);
            const lanes da = max(both - pairs.depth, 1e-3*pairs.depth);
            const lanes beta =
                min(lanes(betaMax_), 1.0 + pairs.depth/da);
            sum += ((1.0 - beta)*row.VW)*(row.U - wall);
        }
        return wall + pairs.invSumVW*sum;
    }

    WallFriction friction() const override
    {
        return {betaMax_, betaMax_, velocity()};
    }
};

static const Boundary::Add<Morris> add
(
    "Morris", "the paper's rough wall with betaMax, Eqs. 21-23"
);

} // namespace
} // namespace sph
