#include "support/Lattice.H"
#include "support/Pairs.H"
#include "support/Threads.H"

#include <gtest/gtest.h>

#include <algorithm>

namespace sph
{

// Neighbours of every particle of a range, sorted; padding must be null
static std::vector<std::vector<label>> neighbours
(
    const PairList& list, const ParticleRange& range, const label null
)
{
    std::vector<std::vector<label>> all(range.size());
    EXPECT_EQ(list.first(), range.begin);
    EXPECT_EQ
    (
        label(list.slices().size()), roundUpToLanes(range.size())/laneCount
    );
    std::int64_t count = 0;
    for (std::size_t s = 0; s < list.slices().size(); ++s)
    {
        const PairList::Slice& slice = list.slices()[s];
        label busiest = 0;
        for (label lane = 0; lane < laneCount; ++lane)
        {
            const label i = label(s)*laneCount + lane;
            label n = 0;
            for (label k = 0; k < slice.n; ++k)
            {
                const label j = slice.rows[k*laneCount + lane];
                if (j != null)
                {
                    EXPECT_EQ(k, n) << "padding before a neighbour";
                    EXPECT_LT(i, range.size()) << "neighbour of a gap";
                    ++n;
                    all.at(i).push_back(j);
                }
            }
            busiest = std::max(busiest, n);
            count += n;
        }
        EXPECT_EQ(slice.n, busiest);
    }
    EXPECT_EQ(list.pairCount(), count);
    for (auto& list : all)
    {
        std::sort(list.begin(), list.end());
    }
    return all;
}

static std::vector<std::vector<label>> bruteForce
(
    const Particles& P, const ParticleRange& range,
    const std::vector<ParticleRange>& candidates, const scalar reach
)
{
    std::vector<std::vector<label>> all(range.size());
    for (label i = range.begin; i < range.end; ++i)
    {
        for (const ParticleRange& others : candidates)
        {
            for (label j = others.begin; j < others.end; ++j)
            {
                if (j != i && (P.r[i] - P.r[j]).squaredNorm() < reach*reach)
                {
                    all[i - range.begin].push_back(j);
                }
            }
        }
        std::sort
        (
            all[i - range.begin].begin(), all[i - range.begin].end()
        );
    }
    return all;
}

static std::int64_t expectAsBruteForce(const Points& points, const scalar reach)
{
    Particles P(1);
    place(P, points, 1);
    const Pairs pairs(P, reach);
    EXPECT_EQ
    (
        neighbours(pairs.list, P.granular(), P.null()),
        bruteForce(P, P.granular(), {P.granular()}, reach)
    );
    return pairs.list.pairCount();
}

TEST(pairList, asBruteForceOnRandomSets)
{
    for (unsigned seed = 1; seed <= 5; ++seed)
    {
        const label n = 100 + 173*label(seed);
        const Points points = randomPoints(n, {-3, 2}, {7, 5}, seed);
        for (const scalar reach : {0.07, 0.5, 1.3, 4.0, 30.0})
        {
            expectAsBruteForce(points, reach);
        }
    }
}

TEST(pairList, asBruteForceOnClusters)
{
    Points points;
    for (unsigned c = 0; c < 6; ++c)
    {
        const vector centre(std::pow(c, 3), -2.0*c);
        const Points cluster = randomPoints
        (
            60, centre, centre + vector(0.3, 0.2), c + 1
        );
        points.insert(points.end(), cluster.begin(), cluster.end());
    }
    EXPECT_GT(expectAsBruteForce(points, 0.1), 1000);
    EXPECT_EQ(expectAsBruteForce(points, 0.5), 6*60*59);
}

TEST(pairList, asBruteForceOnALattice)
{
    const Points points = squareLattice({0, 0}, 13, 11, 0.1);
    EXPECT_EQ(expectAsBruteForce(points, 0.105), 2*(12*11 + 13*10));
}

TEST(pairList, holdsNothingOfNothing)
{
    Particles P(1);
    place(P, {}, 1);
    const Pairs pairs(P, 0.5);
    EXPECT_TRUE(pairs.list.slices().empty());
    EXPECT_EQ(pairs.list.pairCount(), 0);
}

TEST(pairList, aSingleParticleIsAlone)
{
    EXPECT_EQ(expectAsBruteForce({{3, -4}}, 0.5), 0);
    // Where the null particle stands
    EXPECT_EQ(expectAsBruteForce({{0, 0}}, 0.5), 0);
}

TEST(pairList, findsParticlesAtTheSamePlace)
{
    EXPECT_EQ(expectAsBruteForce(Points(9, vector(1, 1)), 0.5), 72);
}

TEST(pairList, findsPairsOnALine)
{
    for (const vector& direction : {vector(1, 0), vector(0, 1), vector(1, 1)})
    {
        Points points;
        for (label i = 0; i < 200; ++i)
        {
            points.push_back(0.1*i*direction.normalized());
        }
        EXPECT_EQ(expectAsBruteForce(points, 0.15), 2*199);
    }
}

// The grid must neither overflow nor take memory for the empty space
TEST(pairList, findsPairsInAHugeExtent)
{
    Points points = randomPoints(100, {0, 0}, {1, 1});
    const std::int64_t near = expectAsBruteForce(points, 0.2);
    points.push_back({1e9, 3e8});
    points.push_back({1e9 + 0.125, 3e8});
    points.push_back({-1e9, 7e8});
    EXPECT_EQ(expectAsBruteForce(points, 0.2), near + 2);
}

TEST(pairList, takesCandidatesOutOfTheGivenRanges)
{
    const scalar reach = 0.3;
    Particles P(1);
    P.resize(70, 45);
    P.resizeGhosts(33);
    const Points points = randomPoints(148, {0, 0}, {2, 1}, 3);
    label k = 0;
    for (const ParticleRange& range : {P.granular(), P.walls(), P.ghosts()})
    {
        for (label i = range.begin; i < range.end; ++i)
        {
            P.r.set(i, points[k++]);
        }
    }
    CellGrid grid;
    grid.build(P.r, {P.granular(), P.walls(), P.ghosts()}, reach);

    const ParticleRange all[2] = {{0, P.null()}, {0, 0}};
    PairList list;
    list.build(P.r, P.granular(), grid, all, reach, P.null());
    EXPECT_EQ
    (
        neighbours(list, P.granular(), P.null()),
        bruteForce
        (
            P, P.granular(), {P.granular(), P.walls(), P.ghosts()}, reach
        )
    );

    // Walls see the material and the first 20 images
    const ParticleRange images{P.ghosts().begin, P.ghosts().begin + 20};
    const ParticleRange material[2] = {P.granular(), images};
    list.build(P.r, P.walls(), grid, material, reach, P.null());
    EXPECT_EQ
    (
        neighbours(list, P.walls(), P.null()),
        bruteForce(P, P.walls(), {P.granular(), images}, reach)
    );
}

TEST(pairList, everyPairStandsInBothLists)
{
    Particles P(1);
    place(P, randomPoints(500, {0, 0}, {4, 4}), 1);
    const Pairs pairs(P, 0.4);
    const auto lists = neighbours(pairs.list, P.granular(), P.null());
    for (label i = 0; i < P.granular().end; ++i)
    {
        for (const label j : lists[i])
        {
            EXPECT_TRUE
            (
                std::binary_search(lists[j].begin(), lists[j].end(), i)
            );
        }
    }
}

// Entry by entry, as the order of a sum decides its rounding
TEST(pairList, doesNotDependOnTheNumberOfThreads)
{
    Particles P(1);
    place(P, randomPoints(1003, {0, 0}, {4, 4}), 1);
    std::vector<std::vector<label>> rows;
    for (const int threads : {1, 2, 3})
    {
        const Threads set(threads);
        const Pairs pairs(P, 0.4);
        rows.emplace_back();
        for (const PairList::Slice& slice : pairs.list.slices())
        {
            rows.back().insert
            (
                rows.back().end(), slice.rows, slice.rows + slice.n*laneCount
            );
        }
    }
    EXPECT_GT(rows[0].size(), 10000u);
    EXPECT_EQ(rows[0], rows[1]);
    EXPECT_EQ(rows[0], rows[2]);
}

TEST(pairList, canBeBuiltAgain)
{
    Particles P(1);
    place(P, randomPoints(300, {0, 0}, {2, 2}), 1);
    Pairs pairs(P, 0.4);
    place(P, randomPoints(90, {0, 0}, {3, 1}, 2), 1);
    pairs.grid.build(P.r, {P.granular()}, 0.2);
    const ParticleRange all[2] = {P.granular(), {0, 0}};
    pairs.list.build(P.r, P.granular(), pairs.grid, all, 0.2, P.null());
    EXPECT_EQ
    (
        neighbours(pairs.list, P.granular(), P.null()),
        bruteForce(P, P.granular(), {P.granular()}, 0.2)
    );
}

} // namespace sph
