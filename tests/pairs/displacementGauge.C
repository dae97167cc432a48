#include "pairs/DisplacementGauge.H"
#include "pairs/PairList.H"
#include "support/Lattice.H"

#include <gtest/gtest.h>

#include <random>

namespace sph
{
namespace
{

constexpr scalar cutOff = 0.25, skin = 0.05, reach = cutOff + skin;

struct displacementGauge : testing::Test
{
    Particles P{0.1};
    CellGrid grid;
    DisplacementGauge gauge;
    Points built;

    void build(const Points& points)
    {
        place(P, points, 1);
        grid.build(P.r, {P.granular()}, reach);
        gauge.reset(P.r, {P.granular()});
        built = points;
    }

    bool complete() { return gauge.complete(P.r, grid, cutOff, skin); }

    void move(const label i, const vector& d) { P.r.set(i, built[i] + d); }

    // A pair within the cut-off that was out of reach when built
    bool missesAPair() const
    {
        for (label i = 0; i < P.granular().end; ++i)
        {
            for (label j = 0; j < i; ++j)
            {
                if
                (
                    (P.r[i] - P.r[j]).norm() < cutOff
                 && (built[i] - built[j]).norm() >= reach
                )
                {
                    return true;
                }
            }
        }
        return false;
    }
};

} // namespace

TEST_F(displacementGauge, whatMovesTogetherKeepsItsList)
{
    build(randomPoints(300, {0, 0}, {3, 2}));
    for (label i = 0; i < P.granular().end; ++i)
    {
        move(i, vector(0.6, -0.8)*0.49*(reach + skin));
    }
    EXPECT_TRUE(complete());
}

TEST_F(displacementGauge, seesTwoThatMeet)
{
    // 0.301 apart, then 0.249
    build({{0, 0}, {0.301, 0}, {2, 2}});
    move(0, {0.026, 0});
    move(1, {0.275 - 0.301, 0});
    EXPECT_TRUE(missesAPair());
    EXPECT_FALSE(complete());
}

TEST_F(displacementGauge, seesTwoThatMeetAcrossACell)
{
    // In cells 0 and 2: with an empty cell between
    build({{0.299, 0.1}, {0.601, 0.1}, {0, 0}, {0.9, 0}});
    move(0, {0.027, 0});
    move(1, {-0.027, 0});
    EXPECT_TRUE(missesAPair());
    EXPECT_FALSE(complete());
}

TEST_F(displacementGauge, seesTwoThatMeetFromFarAway)
{
    build({{0, 0}, {5, 0}});
    move(0, {2.4, 0});
    move(1, {-2.4, 0});
    EXPECT_TRUE(missesAPair());
    EXPECT_FALSE(complete());
}

TEST_F(displacementGauge, refusesWhatIsNotANumber)
{
    build({{0, 0}, {1, 0}});
    move(0, {NAN, 0});
    move(1, {1, 0});
    EXPECT_FALSE(complete());
}

// Rough and smooth motions of all sizes: a list that is called complete is so,
// and a smooth motion by many skins is called so
TEST_F(displacementGauge, isRightAboutRandomMotions)
{
    std::mt19937_64 engine(5);
    std::uniform_real_distribution<scalar> number(-1, 1);
    label kept = 0, missed = 0;
    for (label trial = 0; trial < 300; ++trial)
    {
        build(randomPoints(200, {0, 0}, {2, 2}));
        const scalar rough = 0.05*std::abs(number(engine));
        const vector drift(0.1*number(engine), 0.1*number(engine));
        const scalar shear = 0.06*number(engine);
        for (label i = 0; i < P.granular().end; ++i)
        {
            const vector d =
                drift + vector(shear*built[i].y(), 0)
              + rough*vector(number(engine), number(engine));
            move(i, d);
        }
        const bool called = complete();
        EXPECT_FALSE(called && missesAPair()) << trial;
        kept += called;
        missed += missesAPair();
    }
    EXPECT_GT(kept, 30);
    EXPECT_GT(missed, 30);
}

} // namespace sph
