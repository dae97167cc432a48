#include "sideWalls/SideWalls.H"
#include "support/Lattice.H"
#include "support/Pairs.H"

#include <gtest/gtest.h>

namespace sph
{

namespace
{

// One particle between walls that bear 2 muWall P/(rho W) = 3 m/s2
struct Between
{
    Particles P{0.01};
    std::unique_ptr<SideWalls> walls =
        make<SideWalls>("Coulomb; W 0.02; muWall 0.3;");

    Between()
    {
        place(P, {{0, 0}}, 1500);
        P.p[0] = 200;
        P.q[0] = -50;
    }

    vector drag(const vector& U, const vector& a, const scalar dt)
    {
        P.U.set(0, U);
        P.a.set(0, a);
        walls->addDrag(P, P.granular(), dt);
        return P.a[0];
    }
};

constexpr scalar tiny = 1e-12;

} // namespace

TEST(CoulombSideWalls, holdWhatIsPushedTooLittle)
{
    Between one;
    for (const scalar dt : {0.0, 1e-5, 1e-2})
    {
        EXPECT_LT(one.drag({0, 0}, {1.7, -2.4}, dt).norm(), tiny);
        EXPECT_EQ(one.drag({0, 0}, {0, 0}, dt), vector(0, 0));
        // 5 m/s2 less 3 m/s2
        const vector a = one.drag({0, 0}, {3, -4}, dt);
        EXPECT_LT((a - vector(1.2, -1.6)).norm(), tiny) << dt;
    }
}

TEST(CoulombSideWalls, slowDownAgainstTheVelocity)
{
    Between one;
    EXPECT_LT((one.drag({2, 0}, {0, 0}, 1e-3) - vector(-3, 0)).norm(), tiny);
    EXPECT_LT
    (
        (one.drag({-0.6, 0.8}, {0, 0}, 1e-3) - vector(1.8, -2.4)).norm(), tiny
    );
}

TEST(CoulombSideWalls, stopWithinAStepAndReverseNothing)
{
    Between one;
    const scalar dt = 1e-3;
    for (const scalar U : {1e-9, 1e-4, 2.9e-3})
    {
        EXPECT_LT(std::abs(U + dt*one.drag({U, 0}, {0, 0}, dt).x()), 1e-15);
    }
    EXPECT_NEAR(3.1e-3 + dt*one.drag({3.1e-3, 0}, {0, 0}, dt).x(), 1e-4, 1e-12);
    // Against a push that would reverse it
    EXPECT_LT(std::abs(2e-3 + dt*one.drag({2e-3, 0}, {-4, 0}, dt).x()), 1e-15);
}

TEST(CoulombSideWalls, doNothingWithoutPressure)
{
    Between one;
    one.P.q[0] = -300;
    EXPECT_EQ(one.drag({1, 2}, {3, 4}, 1e-3), vector(3, 4));
}

TEST(CoulombSideWalls, entriesAreChecked)
{
    EXPECT_THROW(make<SideWalls>("Coulomb; W 0; muWall 0.3;"), IOError);
    EXPECT_THROW(make<SideWalls>("Coulomb; W 0.1;"), IOError);
    EXPECT_THROW(make<SideWalls>("Jop; W 0.1;"), IOError);
}

} // namespace sph
