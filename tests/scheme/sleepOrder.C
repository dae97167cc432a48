// Particles in memory: those that are awake, those that they see, and others.
#include "support/Scene.H"

#include <gtest/gtest.h>

#include <algorithm>

namespace sph
{

namespace
{

// Random particles asleep, velocity and density tell who is who
struct orderOfSleepers : testing::TestWithParam<const char*>
{
    static constexpr scalar dx = 0.1;
    static constexpr label nx = 40, ny = 21, n = nx*ny;

    Points points = squareLattice({0, 0}, nx, ny, dx);
    std::unique_ptr<TestScene> scene;
    std::vector<char> slept;        // by identity

    void SetUp() override
    {
        CaseText text = CaseText::plain();
        text.boundary =
            "bed { type noSlip; points ((0 0 0) (4 0 0)); }" +
            std::string
            (
                GetParam() == std::string("symmetryPlane")
              ? "axis { type symmetryPlane; point (0 0 0); normal (1 0 0); }"
              : "ends { type periodic; point (0 0 0); translation (4 0 0); }"
            );
        shake(points, 0.3*dx);
        std::shuffle(points.begin(), points.end(), std::mt19937(3));
        scene = std::make_unique<TestScene>(text, dx, points);
    }

    // Those within a distance of some random points are awake
    void update(const label spots, const scalar radius, const unsigned seed)
    {
        Particles& P = scene->particles;
        slept.assign(n, true);
        for (const vector& x : randomPoints(spots, {0, 0}, {4, 2.1}, seed))
        {
            for (label i = 0; i < n; ++i)
            {
                slept[P.id[i]] &= (P.r[i] - x).norm() > radius;
            }
        }
        for (label i = 0; i < n; ++i)
        {
            P.asleep[i] = slept[P.id[i]];
            P.Umean.set(i, P.r[i]);
            P.U.set(i, P.r[i]);
            P.rho[i] = 1000 + P.id[i];
        }
        scene->scheme.neighbourhood().reset();
        scene->scheme.updatePairs();
    }

    void expectRanges() const
    {
        const Particles& P = scene->particles;
        for (const label end : {P.awake().end, P.active().end})
        {
            EXPECT_TRUE(end % laneCount == 0 || end == n) << end;
        }
        const label nAwake =
            label(std::count(slept.begin(), slept.end(), false));
        EXPECT_GE(P.awake().end, nAwake);
        EXPECT_LT(P.awake().end, nAwake + laneCount);
        for (label i = 0; i < n; ++i)
        {
            EXPECT_EQ(P.asleep[i] == 1, i >= P.awake().end);
            // Nobody falls asleep; those that fill up a slice are at rest
            EXPECT_TRUE(i < P.awake().end || slept[P.id[i]]);
            if (i < P.awake().end && slept[P.id[i]])
            {
                EXPECT_EQ(P.asleep[i], 0.5);
                EXPECT_EQ(P.Umean[i], vector(0, 0));
            }
        }
    }

    void expectStateWithIdentity() const
    {
        const Particles& P = scene->particles;
        std::vector<bool> seen(n, false);
        for (label i = 0; i < n; ++i)
        {
            EXPECT_FALSE(seen.at(P.id[i]));
            seen.at(P.id[i]) = true;
            EXPECT_EQ(P.r[i], points[P.id[i]]);
            EXPECT_EQ(P.U[i], points[P.id[i]]);
            EXPECT_EQ(P.rho[i], 1000 + P.id[i]);
        }
    }

    // Neighbours in the lists of those that are awake: sleepers that do not
    // watch, images of such, and images
    struct Neighbours
    {
        label unwatched = 0, unwatchedImages = 0, images = 0;
    };
    Neighbours neighbours() const
    {
        const Particles& P = scene->particles;
        const scalar reach = scene->scheme.kernel().cutOff() + 0.2*1.3*dx;
        std::vector<label> place(n);
        for (label i = 0; i < n; ++i)
        {
            place.at(P.id[i]) = i;
        }
        Neighbours found;
        for (label i = 0; i < P.awake().end; ++i)
        {
            for (label j = P.active().end; j < n; ++j)
            {
                found.unwatched += (P.r[i] - P.r[j]).norm() < reach;
            }
            for (label j = P.ghosts().begin; j < P.ghosts().end; ++j)
            {
                if ((P.r[i] - P.r[j]).norm() < reach && P.patch[j] < 0)
                {
                    found.unwatchedImages +=
                        place.at(P.id[j]) >= P.active().end;
                    ++found.images;
                }
            }
        }
        return found;
    }
};

} // namespace

TEST_P(orderOfSleepers, isThatOfTheRanges)
{
    label images = 0;
    for (const scalar radius : {0.5*dx, 2*dx, 6*dx})
    {
        for (const label spots : {1, 2, 5, 20})
        {
            for (const unsigned seed : {1u, 2u, 3u, 4u})
            {
                update(spots, radius, seed);
                expectRanges();
                expectStateWithIdentity();
                const Neighbours found = neighbours();
                EXPECT_EQ(found.unwatched, 0);
                EXPECT_EQ(found.unwatchedImages, 0);
                images += found.images;
            }
        }
    }
    EXPECT_GT(images, 100);
}

// One that comes near sleepers is seen at the next rebuild
TEST_P(orderOfSleepers, followsThoseThatMove)
{
    update(1, 2*dx, 1);
    Particles& P = scene->particles;
    const label far = P.granular().end - 1;
    ASSERT_GE(far, P.active().end);
    P.r.set(0, P.r[far] + vector(0.3*dx, 0));
    scene->scheme.updatePairs();
    EXPECT_EQ(neighbours().unwatched, 0);
}

TEST_P(orderOfSleepers, leavesThoseThatNobodySees)
{
    update(1, 2*dx, 1);
    const Particles& P = scene->particles;
    EXPECT_GT(P.awake().size(), 5);
    EXPECT_LT(P.active().end, n/3);
    EXPECT_LT
    (
        scene->scheme.neighbourhood().granularPairs().pairCount(), n/3*40
    );
}

TEST_P(orderOfSleepers, knowsAllAndNobody)
{
    update(1, 100, 1);
    expectRanges();
    EXPECT_EQ(scene->particles.awake().end, n);
    update(0, 0, 1);
    expectRanges();
    expectStateWithIdentity();
    EXPECT_EQ(scene->particles.awake().end, 0);
    EXPECT_EQ(scene->particles.active().end, 0);
    EXPECT_EQ(scene->scheme.neighbourhood().granularPairs().pairCount(), 0);
    EXPECT_FALSE(scene->scheme.neighbourhood().update());
}

TEST_P(orderOfSleepers, setsWhatFollowsFromTheirState)
{
    update(3, 3*dx, 5);
    const Particles& P = scene->particles;
    const ParticleRange sound{P.active().end, n};
    ASSERT_GT(sound.size(), 100);
    const EquationOfState& eos = scene->material.eos();
    for (label i = sound.begin; i < sound.end; ++i)
    {
        EXPECT_DOUBLE_EQ(P.V[i], P.m[i]/P.rho[i]);
        EXPECT_NEAR(P.p[i], eos.pressure(P.rho[i]), 1e-9*eos.K());
        EXPECT_NEAR(P.T.xx[i]*P.rho[i]*P.rho[i], -P.p[i], 1e-9*eos.K());
    }
}

// What is derived and written does not depend on where a particle stood
TEST_P(orderOfSleepers, leavesNothingOfOthers)
{
    Particles& P = scene->particles;
    const std::vector<scalarField*> rates
    {
        &P.q, &P.div, &P.gammaDot, &P.I, &P.gradRho.x, &P.gradRho.y,
        &P.gradU.xx, &P.gradU.xy, &P.gradU.yx, &P.gradU.yy
    };
    for (label i = 0; i < n; ++i)
    {
        P.lambda[i] = 1 + P.id[i];
        for (scalarField* rate : rates)
        {
            (*rate)[i] = 1 + P.id[i];
        }
    }
    update(3, 3*dx, 5);
    label wrong = 0;
    for (label i = P.active().end; i < n; ++i)
    {
        wrong += P.lambda[i] != 1 + P.id[i];
        for (const scalarField* rate : rates)
        {
            wrong += (*rate)[i] != 0;
        }
    }
    EXPECT_EQ(wrong, 0);
}

INSTANTIATE_TEST_SUITE_P
(
    sides, orderOfSleepers, testing::Values("symmetryPlane", "periodic"),
    [](const auto& info) { return info.param; }
);

} // namespace sph
