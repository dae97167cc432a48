#include "boundaries/Boundaries.H"
#include "support/Lattice.H"

#include <gtest/gtest.h>

namespace sph
{

namespace
{

constexpr scalar dx = 0.1;

struct net : testing::Test
{
    Particles P{dx};

    void drop(const vector& r, const vector& U)
    {
        place(P, {r}, 1000);
        P.U.set(0, U);
    }

    label caught(const std::string& text)
    {
        return Boundaries(dictionary::fromString(text, "boundary"), dx).net(P);
    }
};

const char* bed = "bed { type noSlip; points ((0 0 0) (1 0 0)); }";

} // namespace

TEST_F(net, holdsWhatComesTooNear)
{
    drop({0.3, 0.01}, {2, -3});
    EXPECT_EQ(caught(bed), 1);
    EXPECT_LT((P.r[0] - vector(0.3, 0.25*dx)).norm(), 1e-15);
    EXPECT_LT((P.U[0] - vector(2, 0)).norm(), 1e-15);
    EXPECT_EQ(caught(bed), 0);
}

TEST_F(net, fetchesWhatHasPassed)
{
    drop({0.3, -0.12}, {2, -3});
    EXPECT_EQ(caught(bed), 1);
    EXPECT_NEAR(P.r.y[0], 0.25*dx, 1e-15);
    EXPECT_EQ(P.U.y[0], 0);
}

TEST_F(net, leavesASpeedAwayFromTheWall)
{
    drop({0.3, 0.01}, {2, 3});
    EXPECT_EQ(caught(bed), 1);
    EXPECT_EQ(P.U[0], vector(2, 3));
}

TEST_F(net, leavesTheRestAlone)
{
    for
    (
        const vector& r :
        {vector(0.3, 0.026), vector(-0.01, 0.01), vector(1.01, 0.01),
         vector(0.3, -0.21)}
    )
    {
        drop(r, {0, -1});
        EXPECT_EQ(caught(bed), 0) << r.transpose();
        EXPECT_EQ(P.r[0], r);
        EXPECT_EQ(P.U[0], vector(0, -1));
    }
}

TEST_F(net, movesWithTheWall)
{
    drop({0.3, 0.01}, {2, 0.5});
    EXPECT_EQ
    (
        caught
        (
            "bed { type noSlip; points ((0 0 0) (1 0 0)); velocity (0 2 0); }"
        ),
        1
    );
    EXPECT_LT((P.U[0] - vector(2, 2)).norm(), 1e-15);
}

TEST_F(net, worksOnASlope)
{
    const vector n = vector(1, 1).normalized(), t = vector(1, -1).normalized();
    drop(vector(0.5, 0.5) + 0.01*n, 3*t - 2*n);
    EXPECT_EQ
    (
        caught("slope { type freeSlip; points ((0 1 0) (1 0 0)); }"), 1
    );
    EXPECT_NEAR((P.r[0] - vector(0.5, 0.5)).dot(n), 0.25*dx, 1e-14);
    EXPECT_LT((P.U[0] - 3*t).norm(), 1e-14);
}

TEST_F(net, ofASymmetryPlaneIsAMirror)
{
    const char* axis =
        "axis { type symmetryPlane; point (1 0 0); normal (1 0 0); }";
    drop({0.97, 0.4}, {-2, 1});
    EXPECT_EQ(caught(axis), 1);
    EXPECT_LT((P.r[0] - vector(1.03, 0.4)).norm(), 1e-14);
    EXPECT_LT((P.U[0] - vector(2, 1)).norm(), 1e-14);
    EXPECT_EQ(caught(axis), 0);
}

} // namespace sph
