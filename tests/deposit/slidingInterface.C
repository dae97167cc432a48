#include "deposit/slidingInterface.H"
#include "deposit/velocityArrows.H"

#include <gtest/gtest.h>

using namespace sph;

static constexpr scalar dx = 0.01;

// A layer 40 wide and 20 high that flows above y = 0.05 + x/4; at its right end
// all of it flows where moving is set
class Slope : public Particles
{
public:
    explicit Slope(bool moving);
};

Slope::Slope(const bool moving)
:
    Particles(dx)
{
    Particles& P = *this;
    P.resize(40*20, 0);
    for (label i = 0; i < 800; ++i)
    {
        const vector r((i % 40 + 0.5)*dx, (i/40 + 0.5)*dx);
        const bool flows = r.y() > 0.05 + 0.25*r.x() || (moving && r.x() > 0.3);
        P.r.set(i, r);
        P.U.set(i, {flows ? 0.5 : 0.001, 0});
    }
}

TEST(slidingInterface, followsTheLineBelowWhichAllRests)
{
    const auto line = slidingInterface(Slope(false), 0.01);
    ASSERT_EQ(line.size(), 20u);
    for (const vector& r : line)
    {
        EXPECT_NEAR(r.y(), 0.05 + 0.25*r.x(), 0.8*dx) << r.x();
    }
}

TEST(slidingInterface, isTheFootOfWhatMovesAsAWhole)
{
    const auto line = slidingInterface(Slope(true), 0.01);
    ASSERT_EQ(line.size(), 20u);
    EXPECT_NEAR(line.back().y(), 0, 1e-12);
    EXPECT_GT(line.front().y(), 0.04);
}

TEST(slidingInterface, hasNoPointWhereTheSurfaceRests)
{
    EXPECT_TRUE(slidingInterface(Slope(false), 1).empty());
    EXPECT_TRUE(slidingInterface(Particles(dx), 1).empty());
}

TEST(velocityArrows, oneASquare)
{
    const auto arrows = velocityArrows(Slope(false), 5*dx);
    EXPECT_EQ(arrows.size(), 8u*4u);
    EXPECT_EQ(arrows.front().U, vector(0.001, 0));
}
