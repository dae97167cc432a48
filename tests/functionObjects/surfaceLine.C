#include "TestRun.H"

#include "deposit/Profile.H"

using namespace sph;

namespace
{

constexpr scalar dx = 0.005;

// Stairs of 2 dx: 8, 6, 4 and 2 particles high, from x = 0 to 8 dx
scalar stairs(const scalar x)
{
    return dx*(8 - 2*std::floor(x/(2*dx)));
}

struct Stairs : TestRun
{
    explicit Stairs(const BedLine& bed)
    {
        std::vector<vector> points = heaps::below(stairs, 0, 8*dx, dx);
        const vector up(-bed.direction.y(), bed.direction.x());
        for (vector& r : points)
        {
            r = (bed.origin + r.x()*bed.direction + r.y()*up).eval();
        }
        heaps::place(particles, points);
    }
};

void expectStairs
(
    const std::vector<std::vector<scalar>>& rows, const BedLine& bed
)
{
    const vector up(-bed.direction.y(), bed.direction.x());
    scalar volume = 0;
    for (const auto& row : rows)
    {
        ASSERT_EQ(row.size(), 4u);
        const scalar s = row[2], h = row[3];
        const vector place = bed.origin + s*bed.direction + h*up;
        EXPECT_NEAR(h, s > 0 && s < 8*dx ? stairs(s) : 0, 1e-8) << s;
        EXPECT_NEAR(row[0], place.x(), 1e-8);
        EXPECT_NEAR(row[1], place.y(), 1e-8);
        volume += h*2*dx;
    }
    EXPECT_NEAR(volume, 40*dx*dx, 1e-9);
}

} // namespace


TEST(surfaceLine, isThatOfStairsExactly)
{
    const BedLine bed{{0, 0}, {1, 0}};
    Stairs run(bed);
    run.go("top { type surfaceLine; }", 0.07);
    const wordList columns{"x", "y", "s", "h"};
    EXPECT_EQ(run.columns("top/0/surface_0.dat"), columns);
    expectStairs(run.rows("top/0/surface_0.05.dat"), bed);
    EXPECT_FALSE(run.dir.has("postProcessing/top/0/surface_0.01.dat"));
}


TEST(surfaceLine, liesAboveABedThatIsTilted)
{
    const BedLine bed{{0.3, -0.2}, vector(4, 3).normalized()};
    Stairs run(bed);
    run.go
    (
        "top { type surfaceLine; origin (0.3 -0.2 0); direction (4 3 0); }",
        0.01
    );
    expectStairs(run.rows("top/0/surface_0.01.dat"), bed);
}


TEST(surfaceLine, refusesABedWithoutDirection)
{
    TestRun run;
    EXPECT_CONTAINS
    (
        errorOf
        (
            [&]
            {
                run.go("a { type surfaceLine; direction (0 0 0); }", 0.01);
            }
        ),
        "must not be zero"
    );
}
