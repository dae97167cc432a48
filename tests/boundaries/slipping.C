#include "support/Scene.H"

#include <gtest/gtest.h>

namespace sph
{

namespace
{

constexpr scalar dx = 0.05;

// Greatest force along a wall on the row before it, in p/(rho dx), under the
// same pressure everywhere, wherever the row stands before its particles
scalar greatestPush(const std::string& type)
{
    CaseText text = CaseText::plain();
    text.boundary = "bed { type " + type + "; points ((-1 0 0) (2 0 0)); }";
    scalar push = 0;
    for (const scalar offset : {0.0, 0.1, 0.2, 0.3, 0.4})
    {
        TestScene scene(text, dx, squareLattice({offset*dx, 0}, 20, 10, dx));
        Particles& P = scene.particles;
        const scalar p = 0.01*scene.material.eos().K();
        for (label i = 0; i < P.granular().end; ++i)
        {
            P.rho[i] = scene.material.eos().density(p);
        }
        scene.scheme.initialise();
        for (label i = 0; i < P.granular().end; ++i)
        {
            const bool middle = P.r.x[i] > 6*dx && P.r.x[i] < 14*dx;
            if (middle && P.r.y[i] < dx)
            {
                const scalar scale = p/(P.rho[i]*dx);
                push = std::max(push, std::abs(P.a.x[i])/scale);
            }
        }
    }
    return push;
}

} // namespace

TEST(slipping, smoothWallsDoNotHoldTheRowBeforeThem)
{
    const scalar rough = greatestPush("noSlip");
    EXPECT_GT(rough, 0.01);
    EXPECT_LT(greatestPush("freeSlip"), 0.1*rough);
    EXPECT_LT(greatestPush("CoulombWall; muWall 0.3"), 0.1*rough);
}

} // namespace sph
