#include "boundaries/Boundaries.H"

#include <gtest/gtest.h>

namespace sph
{

static constexpr scalar dx = 0.1;

static Boundaries boundaries(const std::string& text)
{
    return Boundaries(dictionary::fromString(text, "boundary"), dx);
}

// The unit box, seen from inside and from outside
static const char* inside =
    "box { type noSlip; points ((0 0 0) (1 0 0) (1 1 0) (0 1 0) (0 0 0)); }";
static const char* outside =
    "box { type noSlip; points ((0 0 0) (0 1 0) (1 1 0) (1 0 0) (0 0 0)); }";

TEST(distanceOfWalls, isPositiveInFrontAndNegativeBehind)
{
    const Boundaries box = boundaries(inside), block = boundaries(outside);
    const std::pair<vector, scalar> points[] =
    {
        {{0.5, 0.5}, 0.5}, {{0.5, 0.1}, 0.1}, {{0.03, 0.02}, 0.02},
        {{0.5, -0.2}, -0.2}, {{1.3, 0.5}, -0.3},
        {{-0.3, -0.4}, -0.5}, {{1.03, 1.04}, -0.05}
    };
    for (const auto& [r, d] : points)
    {
        EXPECT_NEAR(box.distance(r).first, d, 1e-12) << r.transpose();
        EXPECT_NEAR(block.distance(r).first, -d, 1e-12) << r.transpose();
        EXPECT_EQ(box.distance(r).second, "box");
    }
}

// A narrow angle: the point faces one side, and is behind the other's line
TEST(distanceOfWalls, isPositiveOffASharpEdge)
{
    const Boundaries wedge = boundaries
    (
        "wedge { type noSlip; points ((0 -0.2 0) (1 0 0) (0 0.2 0) (0 -0.2 0));"
        " }"
    );
    EXPECT_NEAR(wedge.distance({0.5, 0}).first, 0.5/std::sqrt(26.0)*1, 1e-2);
    EXPECT_LT(wedge.distance({1.1, 0.01}).first, 0);
    EXPECT_LT(wedge.distance({1.1, -0.01}).first, 0);
    EXPECT_LT(wedge.distance({1.02, 0.3}).first, 0);
}

TEST(distanceOfWalls, endsWithAnOpenWall)
{
    const Boundaries bed = boundaries
    (
        "bed { type noSlip; points ((0 0 0) (1 0 0)); }"
    );
    EXPECT_NEAR(bed.distance({0.4, 0.3}).first, 0.3, 1e-14);
    EXPECT_TRUE(std::isinf(bed.distance({-0.1, 0.3}).first));
    EXPECT_TRUE(std::isinf(bed.distance({1.1, -0.3}).first));
}

TEST(distanceOfWalls, isThatOfTheNearestPatch)
{
    const Boundaries two = boundaries
    (
        "bed { type noSlip; points ((0 0 0) (1 0 0)); }"
        "axis { type symmetryPlane; point (0 0 0); normal (2 0 0); }"
        "ends { type periodic; point (0 0 0); translation (5 0 0); }"
    );
    EXPECT_EQ(two.distance({0.5, 0.2}).second, "bed");
    EXPECT_EQ(two.distance({0.1, 0.2}).second, "axis");
    EXPECT_NEAR(two.distance({0.1, 0.2}).first, 0.1, 1e-14);
    EXPECT_NEAR(two.distance({-0.3, 0.2}).first, -0.3, 1e-14);
    EXPECT_TRUE(std::isinf(boundaries("").distance({0, 0}).first));
}

TEST(wallEntries, areChecked)
{
    for
    (
        const char* wrong :
        {
            "bed { type noSlip; points ((0 0 0)); }",
            "bed { type noSlip; points ((0 0 0) (0 0 0)); }",
            "bed { type noSlip; points ((0 0 0) (1 0 0)); layers 0; }",
            "bed { type noSlip; }",
            "bed { type sticky; points ((0 0 0) (1 0 0)); }",
            "axis { type symmetryPlane; point (0 0 0); normal (0 0 0); }",
            "ends { type periodic; point (0 0 0); translation (0 0 0); }",
            "bed { type Morris; betaMax 0.5; points ((0 0 0) (1 0 0)); }"
        }
    )
    {
        EXPECT_THROW(boundaries(wrong), IOError) << wrong;
    }
}

// Depths that a start from a file finds again, at corners too
TEST(setDepths, findsTheDepthOfEveryWallParticle)
{
    const Boundaries box = boundaries(inside);
    const auto walls = box.wallParticles();
    Particles P(dx);
    P.resize(3, label(walls.size()));
    for (label i = 0; i < P.walls().size(); ++i)
    {
        P.r.set(P.walls().begin + i, walls[i].r);
        P.patch[P.walls().begin + i] = 0;
    }
    box.setDepths(P);
    for (label i = 0; i < P.walls().size(); ++i)
    {
        EXPECT_NEAR(P.depth[P.walls().begin + i], walls[i].depth, 1e-12);
    }
}

TEST(setDepths, refusesWallParticlesOfAnotherBoundary)
{
    const Boundaries bed = boundaries
    (
        "bed { type noSlip; points ((0 0 0) (1 0 0)); }"
    );
    const auto walls = bed.wallParticles();
    const auto set = [&](const label n, const vector& shift, const label patch)
    {
        Particles P(dx);
        P.resize(3, n);
        for (label i = 0; i < n; ++i)
        {
            P.r.set(P.walls().begin + i, walls[i].r + shift);
            P.patch[P.walls().begin + i] = patch;
        }
        bed.setDepths(P);
    };
    EXPECT_NO_THROW(set(30, {0, 0}, 0));
    EXPECT_NO_THROW(set(30, {1e-5, 0}, 0)) << "of a file with few digits";
    EXPECT_THROW(set(29, {0, 0}, 0), Error);
    EXPECT_THROW(set(30, {0, 0}, 1), Error);
    EXPECT_THROW(set(30, {0.01, 0}, 0), Error);
    EXPECT_THROW(set(0, {0, 0}, 0), Error);
}

// A particle must not be a neighbour of its own image
TEST(periodicEntries, mustFitTheParticles)
{
    const Boundaries ends = boundaries
    (
        "ends { type periodic; point (0 0 0); translation (1 0 0); }"
    );
    Particles P(dx);
    P.resize(1, 0);
    P.r.set(0, {0.5, 3});
    EXPECT_NO_THROW(ends.check(P, 0.3));
    EXPECT_THROW(ends.check(P, 0.6), Error);
    P.r.set(0, {1.5, 3});
    EXPECT_THROW(ends.check(P, 0.3), Error);
}

} // namespace sph
