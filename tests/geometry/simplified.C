#include "geometry/simplified.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace sph;

namespace
{

std::vector<vector> chosen
(
    const std::vector<vector>& points, const scalar shortest
)
{
    std::vector<vector> left;
    for (const label i : simplified(points, shortest))
    {
        left.push_back(points[i]);
    }
    return left;
}

} // namespace


TEST(simplified, leavesALineOfLongSidesAlone)
{
    const std::vector<vector> line{{0, 0}, {1, 0}, {1, 1}, {2, 5}};
    EXPECT_EQ(simplified(line, 1), (std::vector<label>{0, 1, 2, 3}));
    EXPECT_EQ(simplified(line, 0), (std::vector<label>{0, 1, 2, 3}));
}

TEST(simplified, leavesNothingOfAStraightPart)
{
    std::vector<vector> line;
    for (label k = 0; k <= 11; ++k)
    {
        line.emplace_back(0.1*k, 0.3*k);
    }
    for (label k = 1; k <= 12; ++k)
    {
        line.emplace_back(1.1, 3.3 + 0.1*k);
    }
    for (const scalar shortest : {0.0, 0.25})
    {
        EXPECT_EQ(simplified(line, shortest), (std::vector<label>{0, 11, 23}));
    }
}

// Two arcs of a hundred sides each that meet at a right angle
TEST(simplified, keepsACornerBetweenShortSides)
{
    std::vector<vector> line;
    for (label k = 0; k <= 100; ++k)
    {
        line.emplace_back(std::sin(0.01*k), std::cos(0.01*k));
    }
    const vector corner = line.back();
    for (label k = 1; k <= 100; ++k)
    {
        const vector d(0.01*k, 0.01*k + 0.00005*k*k);
        line.push_back(corner + d);
    }
    for (const scalar shortest : {0.013, 0.027, 0.085, 0.13})
    {
        const auto left = chosen(line, shortest);
        EXPECT_EQ(left.front(), line.front());
        EXPECT_EQ(left.back(), line.back());
        EXPECT_EQ(std::count(left.begin(), left.end(), corner), 1);
        for (std::size_t k = 1; k < left.size(); ++k)
        {
            EXPECT_GE((left[k] - left[k - 1]).norm(), shortest);
        }
        EXPECT_GT(left.size(), 1.6/shortest);
        EXPECT_LT
        (
            greatestDeparture(line, simplified(line, shortest)),
            0.3*shortest*shortest
        );
    }
}

// What is left out was within the shortest side, whatever the line does
TEST(simplified, departsNoFartherThanTheShortestSide)
{
    std::vector<vector> line;
    scalar y = 0;
    for (label k = 0; k <= 2000; ++k)
    {
        y += 0.02*std::sin(12.9898*k*k);    // as good as random
        line.emplace_back(0.01*k, y);
    }
    const auto left = simplified(line, 0.1);
    EXPECT_GT(left.size(), 50u);
    EXPECT_LT(left.size(), 400u);
    EXPECT_LT(greatestDeparture(line, left), 0.1);
    for (std::size_t k = 1; k < left.size(); ++k)
    {
        EXPECT_GE((line[left[k]] - line[left[k - 1]]).norm(), 0.1);
    }
}

TEST(simplified, leavesTheEndsOfALineThatIsShorter)
{
    EXPECT_EQ
    (
        simplified({{0, 0}, {0.1, 0}, {0.2, 0}}, 1),
        (std::vector<label>{0, 2})
    );
}
