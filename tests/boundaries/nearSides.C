#include "boundaries/NearSides.H"

#include "boundaries/Boundaries.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

namespace sph
{

namespace
{

std::vector<vector> wave(const label sides)
{
    std::vector<vector> points;
    for (label k = 0; k <= sides; ++k)
    {
        const scalar x = 4.0*k/sides;
        points.emplace_back(x, 0.3*std::sin(3*x) - 0.1*x);
    }
    return points;
}

scalar distance(const vector& r, const vector& a, const vector& b)
{
    scalar least = 1e30;
    for (label k = 0; k <= 1000; ++k)
    {
        least = std::min(least, (r - a - 0.001*k*(b - a)).norm());
    }
    return least;
}

} // namespace


TEST(NearSides, missNoneWithinReachAndHoldFewMore)
{
    const scalar reach = 0.2;
    const auto points = wave(150);
    const NearSides near(points, reach);
    std::mt19937 random(3);
    std::uniform_real_distribution<scalar> x(-0.5, 4.5), y(-1.2, 0.8);
    for (label trial = 0; trial < 300; ++trial)
    {
        const vector r(x(random), y(random));
        const auto found = near.of(r);
        EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
        for (label s = 0; s < 150; ++s)
        {
            const scalar d = distance(r, points[s], points[s + 1]);
            const bool held = std::binary_search(found.begin(), found.end(), s);
            EXPECT_TRUE(held || d > reach) << r.transpose() << ' ' << s;
            EXPECT_FALSE(held && d > 2.5*reach) << r.transpose() << ' ' << s;
        }
    }
}

// A scene of kilometres with particles of millimetres takes no more memory
TEST(NearSides, areFewCellsHoweverLongTheSides)
{
    const NearSides near({{0, 0}, {3000, 1000}}, 0.001);
    EXPECT_EQ(near.of({1500, 500}).end() - near.of({1500, 500}).begin(), 1);
    EXPECT_EQ(near.of({1500, 600}).end() - near.of({1500, 600}).begin(), 0);
    EXPECT_EQ(near.of({5000, 0}).end(), nullptr);
}

// The net of a bed that is drawn with many sides is that of one with few
TEST(NearSides, leaveTheNetAsItIs)
{
    const scalar dx = 0.02;
    const auto bed = [&](const label sides)
    {
        std::ostringstream os;
        os.precision(17);
        os << "bed { type noSlip; points (";
        for (label k = 0; k <= sides; ++k)
        {
            os << '(' << scalar(k)/sides << ' ' << 0.5*k/sides << " 0)";
        }
        os << "); }";
        return Boundaries(dictionary::fromString(os.str(), "boundary"), dx);
    };
    std::mt19937 random(5);
    std::uniform_real_distribution<scalar> x(0.05, 0.95), y(-0.06, 0.06);
    Particles one(dx);
    one.resize(2000, 0);
    for (label i = 0; i < 2000; ++i)
    {
        const scalar along = x(random);
        one.r.set(i, {along, 0.5*along + y(random)});
        one.U.set(i, {0.1, -1});
    }
    Particles many(dx);
    many.resize(2000, 0);
    many.r = one.r;
    many.U = one.U;
    const label hits = bed(1).net(one);
    EXPECT_GT(hits, 700);
    EXPECT_EQ(bed(64).net(many), hits);
    for (label i = 0; i < 2000; ++i)
    {
        EXPECT_LT((one.r[i] - many.r[i]).norm(), 1e-14);
        EXPECT_LT((one.U[i] - many.U[i]).norm(), 1e-14);
    }
}

} // namespace sph
