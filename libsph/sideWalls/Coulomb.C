// Coulomb friction of the two side walls of a channel of width W, averaged over
// the width:
//
//     a = a' - min(2 muWall P/(rho W), |U'|/dt) U'/|U'|,   U' = U + dt a'
//
// where a' is the acceleration by all else and P = p + q the pressure on the
// walls. The friction is at most what stops a particle within the step: it
// holds what rests, and reverses nothing.
// Jop, Forterre & Pouliquen, J. Fluid Mech. 541, 167 (2005).
//
//     sideWalls  Coulomb;
//     CoulombCoeffs { W 0.019; muWall 0.38; }

#include "particles/ParticleValues.H"
#include "sideWalls/SideWalls.H"

#include <algorithm>

namespace sph
{
namespace
{

class Coulomb : public SideWalls
{
    const scalar W_;
    const scalar muWall_;

public:
    explicit Coulomb(const dictionary& dict)
    :
        W_
        (
            dict.get
            (
                {"W", "width of the channel", "0.019"},
                dimLength, Range::positive()
            )
        ),
        muWall_
        (
            dict.get
            (
                {"muWall", "friction coefficient of the walls", "0.38"},
                dimless, Range::nonNegative()
            )
        )
    {}

    void addDrag
    (
        Particles& particles, const ParticleRange& range, const scalar deltaT
    ) const override
    {
        using namespace of;
        // At a start, what is at rest is held and what moves is not stopped
        const scalar dt = std::max(deltaT, 1e-12);
        const lanes nothing = 1e-100;
        for
        (
            label first = range.begin; first < range.end;
            first += width<lanes>
        )
        {
            const ParticleValues<lanes> i(particles, first);
            const vectorLanes free = i(U) + lanes(dt)*i(a);
            const lanes magFree = sqrt(free & free);
            const lanes P = max(i(p) + i(q), lanes(0));
            const lanes limit = (2*muWall_/W_)*P/i(rho);
            const lanes drag = min(limit, magFree/dt);
            i.set(a, i(a) - (drag/max(magFree, nothing))*free);
        }
    }
};

static const SideWalls::Add<Coulomb> add
(
    "Coulomb", "friction of the two walls of a channel of width W; can hold"
);

} // namespace
} // namespace sph
