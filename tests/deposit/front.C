#include "deposit/front.H"
#include "heaps.H"

#include <gtest/gtest.h>

using namespace sph;

static const BedLine flat{{0, 0}, {1, 0}};

static Fronts frontsOf
(
    const std::vector<vector>& points, const scalar dx, const scalar threshold
)
{
    Particles particles(dx);
    heaps::place(particles, points);
    return fronts(Profile(particles, flat, heaps::rho0, 2*dx), threshold);
}


TEST(front, isLinearBetweenTheCentresOfBins)
{
    const Profile profile(0, 1, {0, 3, 4, 1, 0});
    const Fronts front = fronts(profile, 2);
    EXPECT_DOUBLE_EQ(front.left, 0.5 + 2.0/3);
    EXPECT_DOUBLE_EQ(front.right, 2.5 + 2.0/3);
}


TEST(front, reachesOutOfTheLastBinOfAProfile)
{
    const Fronts front = fronts(Profile(0, 1, {4}), 1);
    EXPECT_DOUBLE_EQ(front.right, 0.5 + 0.75);
    EXPECT_DOUBLE_EQ(front.left, 0.5 - 0.75);
}


// The lattice knows the thickness to half a particle, which is dx L/(2H) of x
TEST(front, ofATriangleConvergesToTheExactPlace)
{
    const scalar L = 0.4137, H = 0.1523, threshold = 0.0125;
    const scalar exact = L*(1 - threshold/H);
    for (const scalar dx : {0.0083, 0.0041, 0.0019, 0.0011, 0.0004})
    {
        const scalar front =
            frontsOf(heaps::triangle(L, H, dx), dx, threshold).right;
        EXPECT_NEAR(front, exact, 0.7*dx) << "dx = " << dx;
    }
}


TEST(front, withAThresholdOfHalfAParticleConvergesToTheTip)
{
    const scalar L = 0.4, H = 0.15;
    for (const scalar dx : {0.008, 0.004, 0.002, 0.001})
    {
        const scalar behind =
            L - frontsOf(heaps::triangle(L, H, dx), dx, 0.5*dx).right;
        EXPECT_NEAR(behind, 0.5*dx*L/H, dx) << "dx = " << dx;
    }
}


TEST(front, isNotMovedByGrainsThatLieApart)
{
    const scalar dx = 0.004;
    std::vector<vector> points = heaps::triangle(0.4, 0.15, dx);
    const Fronts alone = frontsOf(points, dx, 0.5*dx);

    points.emplace_back(0.9, 0.5*dx);
    for (label i = 0; i < 8; ++i)   // a second heap, thick but not connected
    {
        points.emplace_back(0.6, (i + 0.5)*dx);
        points.emplace_back(0.6 + dx, (i + 0.5)*dx);
    }
    points.emplace_back(-0.3, 0.5*dx);
    const Fronts together = frontsOf(points, dx, 0.5*dx);
    EXPECT_NEAR(together.right, alone.right, 1e-12);
    EXPECT_NEAR(together.left, alone.left, 1e-12);
}


TEST(front, ofMirroredHeapsAreMirrored)
{
    const scalar dx = 0.004;
    std::vector<vector> points = heaps::triangle(0.4, 0.15, dx);
    const Fronts one = frontsOf(points, dx, 0.5*dx);
    for (vector& point : points)
    {
        point.x() *= -1;
    }
    const Fronts other = frontsOf(points, dx, 0.5*dx);
    EXPECT_NEAR(other.left, -one.right, 1e-12);
    EXPECT_NEAR(other.right, -one.left, 1e-12);
}


TEST(front, isNoNumberWhereNothingIsThickEnough)
{
    const Fronts front = fronts(Profile(0, 1, {0.1, 0.2}), 0.3);
    EXPECT_TRUE(std::isnan(front.left));
    EXPECT_TRUE(std::isnan(front.right));
}
