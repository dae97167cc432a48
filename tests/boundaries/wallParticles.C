#include "boundaries/Boundaries.H"

#include <gtest/gtest.h>

namespace sph
{

namespace
{

constexpr scalar dx = 0.1;

Boundaries boundaries(const std::string& text)
{
    return Boundaries(dictionary::fromString(text, "boundary"), dx);
}

// Corners of the unit box
const char* inside =
    "box { type noSlip; points ((0 0 0) (1 0 0) (1 1 0) (0 1 0) (0 0 0)); }";
const char* outside =
    "box { type noSlip; points ((0 0 0) (0 1 0) (1 1 0) (1 0 0) (0 0 0)); }";
const char* corner =
    "corner { type noSlip; points ((0 1 0) (0 0 0) (1 0 0)); }";
const char* step =
    "step { type noSlip;"
    " points ((0 0 0) (0.5 0 0) (0.5 -0.5 0) (1.2 -0.5 0)); }";
const char* roof =
    "roof { type noSlip; points ((0 0 0) (0.5 0.3 0) (1 0 0)); }";
const char* valley =
    "valley { type noSlip; points ((0 0.4 0) (0.7 0 0) (1.4 0.4 0)); }";

scalar nearest
(
    const std::vector<WallParticle>& walls, const vector& r,
    const WallParticle* except = nullptr
)
{
    scalar best = 1e30;
    for (const WallParticle& w : walls)
    {
        if (&w != except)
        {
            best = std::min(best, (w.r - r).norm());
        }
    }
    return best;
}

} // namespace

TEST(wallParticles, ofAFlatBed)
{
    const Boundaries bed = boundaries
    (
        "bed { type noSlip; points ((0 0 0) (1 0 0)); layers 4; }"
    );
    const auto walls = bed.wallParticles();
    ASSERT_EQ(walls.size(), 40u);
    scalar deepest = 0;
    for (const WallParticle& w : walls)
    {
        EXPECT_NEAR(w.r.y(), -w.depth, 1e-14);
        EXPECT_LT((w.n - vector(0, 1)).norm(), 1e-14);
        EXPECT_EQ(w.patch, 0);
        EXPECT_NEAR(nearest(walls, w.r, &w), dx, 1e-12);
        EXPECT_GT(w.r.x(), 0);
        EXPECT_LT(w.r.x(), 1);
        deepest = std::max(deepest, w.depth);
    }
    EXPECT_NEAR(deepest, 3.5*dx, 1e-14);
}

TEST(wallParticles, ofASlopeStandBehindIt)
{
    const Boundaries slope = boundaries
    (
        "slope { type noSlip; points ((1 2 0) (2 1 0)); }"
    );
    const auto walls = slope.wallParticles();
    EXPECT_EQ(walls.size(), 3u*14u);
    const vector n = vector(1, 1).normalized();
    for (const WallParticle& w : walls)
    {
        EXPECT_LT((w.n - n).norm(), 1e-14);
        EXPECT_NEAR((w.r - vector(1, 2)).dot(n), -w.depth, 1e-14);
        EXPECT_NEAR(slope.distance(w.r).first, -w.depth, 1e-14);
    }
}

static std::string wallName(const testing::TestParamInfo<const char*>& info)
{
    const char* names[] =
        {"boxInside", "boxOutside", "corner", "step", "roof", "valley"};
    return names[info.index];
}

class cornersOfWalls : public testing::TestWithParam<const char*>
{};

// Neither overlaps ...
TEST_P(cornersOfWalls, noTwoParticlesAreTooClose)
{
    const auto walls = boundaries(GetParam()).wallParticles();
    ASSERT_GT(walls.size(), 20u);
    for (const WallParticle& w : walls)
    {
        const scalar d = nearest(walls, w.r, &w);
        EXPECT_GT(d, 0.64*dx) << w.r.transpose();
        EXPECT_LT(d, 1.3*dx) << w.r.transpose();
    }
}

// ... nor gaps: no point behind the wall is far from its particles
TEST_P(cornersOfWalls, noPlaceIsEmpty)
{
    const Boundaries all = boundaries(GetParam());
    const auto walls = all.wallParticles();
    label sampled = 0;
    for (scalar x = -0.4; x < 1.8; x += 0.021)
    {
        for (scalar y = -1; y < 1.4; y += 0.023)
        {
            const scalar d = all.distance({x, y}).first;
            if (d < -0.3*dx && d > -2.7*dx)
            {
                EXPECT_LT(nearest(walls, {x, y}), dx) << x << ' ' << y;
                ++sampled;
            }
        }
    }
    EXPECT_GT(sampled, 200);
}

TEST_P(cornersOfWalls, particlesAreBehindTheirWallAndLookOut)
{
    const Boundaries all = boundaries(GetParam());
    for (const WallParticle& w : all.wallParticles())
    {
        EXPECT_LT(all.distance(w.r).first, 0) << w.r.transpose();
        EXPECT_NEAR(w.n.norm(), 1, 1e-14);
        EXPECT_GT(w.depth, 0.4*dx);
        EXPECT_LT(w.depth, 2.6*dx);
        // A step along the normal, depth long, ends at the wall or short of it
        EXPECT_LT
        (
            all.distance(w.r + 0.98*w.depth*w.n).first, 0
        ) << w.r.transpose();
    }
}

TEST_P(cornersOfWalls, nothingStandsInFrontOfTheWall)
{
    const Boundaries all = boundaries(GetParam());
    const auto walls = all.wallParticles();
    for (scalar x = -0.4; x < 1.8; x += 0.021)
    {
        for (scalar y = -1; y < 1.4; y += 0.023)
        {
            const scalar d = all.distance({x, y}).first;
            if (d > 0 && std::isfinite(d))
            {
                EXPECT_GT(nearest(walls, {x, y}), 0.49*dx);
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P
(
    all, cornersOfWalls,
    testing::Values(inside, outside, corner, step, roof, valley),
    wallName
);

TEST(wallParticles, aClosedBoxSurroundsOneSide)
{
    for (const WallParticle& w : boundaries(inside).wallParticles())
    {
        EXPECT_GT((w.r - vector(0.5, 0.5)).cwiseAbs().maxCoeff(), 0.5);
        EXPECT_GT(w.n.dot(vector(0.5, 0.5) - w.r), 0);
    }
    for (const WallParticle& w : boundaries(outside).wallParticles())
    {
        EXPECT_LT((w.r - vector(0.5, 0.5)).cwiseAbs().maxCoeff(), 0.5);
        EXPECT_LT(w.n.dot(vector(0.5, 0.5) - w.r), 0);
    }
    // 3 layers around 10 by 10
    EXPECT_EQ(boundaries(inside).wallParticles().size(), 16u*16u - 100u);
}

TEST(wallParticles, twoPatchesShareACorner)
{
    const auto walls = boundaries
    (
        "bed { type noSlip; points ((-0.3 0 0) (1 0 0)); }"
        "side { type Morris; points ((0 1 0) (0 -0.3 0)); }"
    ).wallParticles();
    EXPECT_EQ(walls.size(), 3u*13u + 3u*10u);
    label patches[2] = {0, 0};
    for (const WallParticle& w : walls)
    {
        EXPECT_NEAR(nearest(walls, w.r, &w), dx, 1e-10);
        ++patches[w.patch];
    }
    EXPECT_EQ(patches[0], 39);
}

// Where material slips along the wall two particles share the area of one
TEST(wallParticles, ofASmoothWallStandTwiceAsDense)
{
    const Boundaries bed = boundaries
    (
        "bed { type freeSlip; points ((0 0 0) (1 0 0)); }"
    );
    const auto walls = bed.wallParticles();
    ASSERT_EQ(walls.size(), 2u*3u*10u);
    Particles P(dx);
    P.resize(1, label(walls.size()));
    bed.placeWalls(1500, P);
    scalar mass = 0;
    for (label w = P.walls().begin; w < P.walls().end; ++w)
    {
        EXPECT_NEAR(nearest(walls, P.r[w], &walls[w - P.walls().begin]),
            0.5*dx, 1e-12);
        EXPECT_EQ(P.rho[w], 1500);
        mass += P.m[w];
    }
    EXPECT_NEAR(mass, 1500*0.3*1, 1e-9) << "of three rows, 1 m long";
}

} // namespace sph
