#include "setup/Lattice.H"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

using namespace sph;

namespace
{

Lattice lattice(const std::string& text)
{
    return Lattice(dictionary::fromString(text, "setParticlesDict"));
}

std::unique_ptr<Region> box(const std::string& min, const std::string& max)
{
    return Region::New
    (
        dictionary::fromString
        (
            "type box; min (" + min + " 0); max (" + max + " 0);"
        )
    );
}

vector centroid(const std::vector<vector>& points)
{
    vector sum = vector::Zero();
    for (const vector& point : points)
    {
        sum += point;
    }
    return sum/points.size();
}

// Distances from the particle nearest to a point to all others, sorted
std::vector<scalar> distancesAround
(
    const std::vector<vector>& points, const vector& place
)
{
    const vector centre = *std::min_element
    (
        points.begin(), points.end(),
        [&](const vector& a, const vector& b)
        {
            return (a - place).norm() < (b - place).norm();
        }
    );
    std::vector<scalar> distances;
    for (const vector& point : points)
    {
        if (point != centre)
        {
            distances.push_back((point - centre).norm());
        }
    }
    std::sort(distances.begin(), distances.end());
    return distances;
}

} // namespace


TEST(Lattice, fillsABoxOfWholeMultiplesExactly)
{
    const scalar dx = 0.0025;
    const auto points =
        lattice("spacing 0.0025;").points(*box("-0.05 0.01", "0.05 0.085"));
    EXPECT_EQ(points.size(), 40u*30u);
    EXPECT_LT((centroid(points) - vector(0, 0.0475)).norm(), 1e-12);

    Region::Bounds extent;
    for (const vector& point : points)
    {
        extent.extend(point);
    }
    EXPECT_LT
    (
        (extent.min() - vector(-0.05 + dx/2, 0.01 + dx/2)).norm(), 1e-12
    );
    EXPECT_LT((extent.max() - vector(0.05 - dx/2, 0.085 - dx/2)).norm(), 1e-12);
}

TEST(Lattice, roundsTheNumberOfColumnsAndRows)
{
    // 3.4 and 3.6 spacings; a side of 3.5 gets 3: no particle on the border
    const auto count = [](const std::string& max)
    {
        return lattice("spacing 0.1;").points(*box("0 0", max)).size();
    };
    EXPECT_EQ(count("0.34 0.36"), 3u*4u);
    EXPECT_EQ(count("0.35 0.35"), 3u*3u);
}

TEST(Lattice, aBorderPointIsFoundOnceWhateverItsRounding)
{
    // Lattice points fall on the common border of the two boxes
    const Lattice common = lattice("spacing 0.1; origin (0.05 0.05 0);");
    for (int k = 1; k < 40; ++k)
    {
        const std::string x = std::to_string(0.1*k);
        EXPECT_EQ
        (
            common.points(*box("0.01 0", x + " 1")).size()
          + common.points(*box(x + " 0", "5.01 1")).size(),
            50u*10u
        ) << x;
    }
}

TEST(Lattice, originAlignsRegions)
{
    const Lattice common = lattice("spacing 0.1; origin (0.02 0 0);");
    for (const vector& point : common.points(*box("0.33 0.17", "2 2")))
    {
        const scalar column = (point.x() - 0.02)/0.1 - 0.5;
        const scalar row = point.y()/0.1 - 0.5;
        EXPECT_NEAR(column, std::round(column), 1e-9);
        EXPECT_NEAR(row, std::round(row), 1e-9);
    }
}

TEST(Lattice, squareHasFourNearestNeighbours)
{
    const auto distances = distancesAround
    (
        lattice("spacing 0.1;").points(*box("0 0", "2 2")), {1, 1}
    );
    EXPECT_NEAR(distances[0], 0.1, 1e-12);
    EXPECT_NEAR(distances[3], 0.1, 1e-12);
    EXPECT_NEAR(distances[4], 0.1*std::sqrt(2), 1e-12);
}

TEST(Lattice, hexagonalHasSixNearestNeighboursAndTheSameDensity)
{
    const auto points = lattice("spacing 0.02; lattice hexagonal;").points
    (
        *box("0 0", "2 2")
    );
    const auto distances = distancesAround(points, {1, 1});
    const scalar nearest = 0.02*std::pow(4.0/3, 0.25);
    EXPECT_NEAR(distances[0], nearest, 1e-12);
    EXPECT_NEAR(distances[5], nearest, 1e-12);
    EXPECT_NEAR(distances[6], nearest*std::sqrt(3), 1e-12);
    EXPECT_NEAR(points.size()*0.02*0.02, 4, 0.04);
}

TEST(Lattice, liesAlongTheSidesOfARotatedBox)
{
    const auto shape = Region::New
    (
        dictionary::fromString
        (
            "type rotatedBox; origin (1 1 0); i (0.8 0.6 0); j (-0.3 0.4 0);"
        )
    );
    const auto points = lattice("spacing 0.05;").points(*shape);
    EXPECT_EQ(points.size(), 20u*10u);
    EXPECT_LT((centroid(points) - vector(1.25, 1.5)).norm(), 1e-12);
}

TEST(Lattice, aCircleIsFilledSymmetrically)
{
    const auto shape = Region::New
    (
        dictionary::fromString("type circle; centre (3 1 0); radius 1;")
    );
    const auto points = lattice("spacing 0.02;").points(*shape);
    EXPECT_LT((centroid(points) - vector(3, 1)).norm(), 1e-9);
    EXPECT_NEAR(points.size()*0.0004, pi, 0.01*pi);
}

TEST(Jitter, isBoundedAndReproducible)
{
    const auto shape = box("0 0", "1 1");
    const auto anywhere = [](const vector&) { return true; };
    const auto shaken = [&]
    (
        const std::string& entries,
        const std::function<bool(const vector&)>& allowed
    )
    {
        Lattice jittering = lattice("spacing 0.02; " + entries);
        auto points = jittering.points(*shape);
        jittering.shake(points, allowed);
        return points;
    };
    const auto still = shaken("", anywhere);
    const auto first = shaken("jitter 0.2; seed 7;", anywhere);
    const auto again = shaken("jitter 0.2; seed 7;", anywhere);
    const auto other = shaken("jitter 0.2; seed 8;", anywhere);
    const auto upright = shaken
    (
        "jitter 0.2; seed 7;", [](const vector& x) { return x.y() >= 0.01; }
    );
    EXPECT_EQ(first, again);
    EXPECT_NE(first, other);

    scalar largest = 0;
    vector mean = vector::Zero();
    for (std::size_t i = 0; i < still.size(); ++i)
    {
        const vector shift = first[i] - still[i];
        largest = std::max(largest, shift.cwiseAbs().maxCoeff());
        mean += shift/still.size();
        EXPECT_EQ(upright[i], first[i].y() >= 0.01 ? first[i] : still[i]);
    }
    EXPECT_LE(largest, 0.2*0.02 + 1e-15);
    EXPECT_GT(largest, 0.19*0.02);

    // Standard deviation of the mean: 0.004/sqrt(3*2500)
    EXPECT_LT(mean.cwiseAbs().maxCoeff(), 5*0.004/std::sqrt(7500.0));
}

TEST(LatticeErrors, nameTheEntry)
{
    const auto expectError = [](const std::string& text, const word& entry)
    {
        try
        {
            lattice(text);
            FAIL() << "no error for " << text;
        }
        catch (const IOError& error)
        {
            EXPECT_NE(error.block().find(entry), std::string::npos)
                << error.block();
            EXPECT_GT(error.startLine(), 0);
        }
    };
    expectError("lattice square;", "spacing");
    expectError("spacing 0;", "spacing");
    expectError("spacing -0.1;", "spacing");
    expectError("spacing 0.1; lattice cubic;", "hexagonal");
    expectError("spacing 0.1; jitter 0.5;", "jitter");
    expectError("spacing 0.1; jitter -0.1;", "jitter");
}
