#include "pairs/CellGrid.H"
#include "support/Lattice.H"

#include <gtest/gtest.h>

#include <algorithm>

namespace sph
{

static CellGrid binned(const Particles& P, const scalar width)
{
    CellGrid grid;
    grid.build(P.r, {P.granular()}, width);
    return grid;
}

TEST(cellGrid, holdsEveryParticleOnceWithItsPosition)
{
    Particles P(1);
    place(P, randomPoints(777, {-1, 4}, {2, 5}), 1);
    const CellGrid grid = binned(P, 0.1);
    std::vector<bool> seen(777, false);
    for (std::size_t k = 0; k < seen.size(); ++k)
    {
        const label i = grid.particles()[k];
        EXPECT_FALSE(seen.at(i));
        seen.at(i) = true;
        EXPECT_EQ(grid.x()[k], P.r.x[i]);
        EXPECT_EQ(grid.y()[k], P.r.y[i]);
    }
}

// Same cell: in order of index
TEST(cellGrid, isStable)
{
    Particles P(1);
    place(P, randomPoints(50, {0, 0}, {0.01, 0.01}), 1);
    const CellGrid grid = binned(P, 1);
    EXPECT_TRUE
    (
        std::is_sorted
        (
            grid.particles().begin(), grid.particles().begin() + 50
        )
    );
}

TEST(cellGrid, rowsOfCellsAreNearInMemory)
{
    Particles P(1);
    Points points = squareLattice({0, 0}, 4, 3, 1);
    std::reverse(points.begin(), points.end());
    place(P, points, 1);
    const CellGrid grid = binned(P, 1);
    for (label k = 0; k < 12; ++k)
    {
        EXPECT_EQ(grid.particles()[k], 11 - k);
    }
}

// Whatever lies within one width of a point is in its three runs, once
TEST(cellGrid, runsHoldWhatIsWithinOneWidth)
{
    Particles P(1);
    const scalar width = 0.2;
    place(P, randomPoints(400, {0, 0}, {2, 1}), 1);
    const CellGrid grid = binned(P, width);
    for (const vector& x : randomPoints(200, {-1, -1}, {3, 2}, 9))
    {
        CellGrid::Run runs[3];
        grid.runsAround(x.x(), x.y(), runs);
        std::vector<label> count(400, 0);
        for (const CellGrid::Run& run : runs)
        {
            for (label k = run.begin; k < run.end; ++k)
            {
                ++count[grid.particles()[k]];
            }
        }
        for (label i = 0; i < 400; ++i)
        {
            EXPECT_LE(count[i], 1);
            if ((P.r[i] - x).norm() < width)
            {
                EXPECT_EQ(count[i], 1);
            }
        }
    }
}

// Rows of one cell and columns of one cell too
TEST(cellGrid, dilateReachesTheEightCellsAround)
{
    const std::vector<std::pair<label, label>> sizes
    {
        {1, 1}, {1, 2}, {2, 1}, {1, 17}, {17, 1}, {2, 2}, {9, 6}, {23, 31}
    };
    std::mt19937_64 engine(11);
    for (const auto& [nx, ny] : sizes)
    {
        Particles P(1);
        place(P, squareLattice({0, 0}, nx, ny, 1), 1);
        const CellGrid grid = binned(P, 1);
        ASSERT_EQ(grid.nx(), nx);
        ASSERT_EQ(grid.ny(), ny);
        for (const scalar share : {0.0, 0.02, 0.1, 0.4, 1.0})
        {
            std::vector<char> flags(std::size_t(nx)*ny);
            std::bernoulli_distribution flag(share);
            std::generate
            (
                flags.begin(), flags.end(), [&]{ return flag(engine); }
            );
            std::vector<char> expected(flags.size(), false);
            for (label c = 0; c < nx*ny; ++c)
            {
                for (label d = 0; d < nx*ny; ++d)
                {
                    const bool near =
                        std::abs(c % nx - d % nx) <= 1
                     && std::abs(c/nx - d/nx) <= 1;
                    expected[c] |= near && flags[d];
                }
            }
            grid.dilate(flags);
            EXPECT_EQ(flags, expected) << nx << " x " << ny << ' ' << share;
        }
    }
}

TEST(cellGrid, knowsTheCellOfEveryParticle)
{
    Particles P(1);
    place(P, randomPoints(300, {0, 0}, {2, 1}), 1);
    const CellGrid grid = binned(P, 0.1);
    for (label i = 0; i < 300; ++i)
    {
        for (label j = 0; j < 300; ++j)
        {
            const label a = grid.cells()[i], b = grid.cells()[j];
            const label dx = std::abs(a % grid.nx() - b % grid.nx());
            const label dy = std::abs(a/grid.nx() - b/grid.nx());
            if ((P.r[i] - P.r[j]).norm() < 0.1)
            {
                EXPECT_LE(std::max(dx, dy), 1);
            }
            else if ((P.r[i] - P.r[j]).norm() > 0.3)
            {
                EXPECT_GT(std::max(dx, dy), 1);
            }
        }
    }
}

TEST(cellGrid, ofNothingHasEmptyRuns)
{
    Particles P(1);
    place(P, {}, 1);
    const CellGrid grid = binned(P, 1);
    CellGrid::Run runs[3];
    grid.runsAround(0, 0, runs);
    for (const CellGrid::Run& run : runs)
    {
        EXPECT_EQ(run.begin, run.end);
    }
}

} // namespace sph
