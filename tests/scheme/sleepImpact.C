// A bed that sleeps is woken by what falls on it.
#include "../runTime/TestCase.H"
#include "io/caseIO.H"
#include "scheme/SleepScene.H"
#include "support/Threads.H"

#include <gtest/gtest.h>

#include <set>

namespace sph
{

namespace
{

constexpr scalar g = 9.81;

// A bed, and a block in the air above its left part
struct Impact : SleepScene
{
    static constexpr scalar dx = 0.005, x0 = 0.1, length = 0.5;
    static constexpr label bedSize = 100*8;

    static CaseText text()
    {
        CaseText text;
        text.equationOfState =
            "equationOfState linear; linearCoeffs { KFactor 100; H 0.05; }";
        text.boundary =
            "box { type noSlip; points"
            " ((0 0.3 0) (0 0 0) (0.5 0 0) (0.5 0.3 0)); }";
        return text;
    }

    static Points points()
    {
        Points all = squareLattice({0, 0}, 100, 8, dx);
        const Points block = squareLattice({x0 - 4*dx, 0.16}, 8, 8, dx);
        all.insert(all.end(), block.begin(), block.end());
        return all;
    }

    Impact()
    :
        SleepScene(text(), dx, points())
    {
        Particles& P = particles;
        const scalar K = material.eos().K();
        for (label i = 0; i < bedSize; ++i)
        {
            P.rho[i] = CaseText::rho0
               *std::exp(CaseText::rho0*g*(8*dx - P.r.y[i])/K);
        }
        for (label i = bedSize; i < P.granular().end; ++i)
        {
            P.U.set(i, {0, -1});
        }
        scheme.initialise();
    }

    std::map<std::int64_t, vector> positions() const
    {
        std::map<std::int64_t, vector> all;
        for (const auto& [id, i] : places())
        {
            all[id] = particles.r[i];
        }
        return all;
    }

    // Of the bed
    scalar largestDisplacement
    (
        const std::map<std::int64_t, vector>& before
    ) const
    {
        scalar largest = 0;
        for (const auto& [id, r] : positions())
        {
            if (id < bedSize)
            {
                largest = std::max(largest, (r - before.at(id)).norm());
            }
        }
        return largest;
    }
};

} // namespace

// Largest displacement of the bed without sleep [m]
static scalar displacementWithoutSleep()
{
    Impact scene;
    scene.startSleep("", Impact::text());
    const scalar dt = scene.acousticStep();
    scene.run(dt, label(0.08/dt));
    const auto before = scene.positions();
    scene.run(dt, label(0.4/dt));
    return scene.largestDisplacement(before);
}

TEST(impact, wakesTheBedBelowAndNotFarAway)
{
    Impact scene;
    const scalar dt = scene.acousticStep();
    const Particles& P = scene.particles;
    const label n = P.granular().size();

    // Until the block is about to touch the bed
    scene.run(dt, label(0.08/dt));
    EXPECT_GT(scene.asleep(), 0.9*Impact::bedSize);
    const auto before = scene.positions();

    std::set<std::int64_t> woken;
    for (label k = 0; k < label(1/dt) && scene.asleep() < n; ++k)
    {
        scene.step(dt);
        for (label i = 0; i < P.awake().end; ++i)
        {
            woken.insert(P.id[i]);
        }
    }
    EXPECT_EQ(scene.asleep(), n);
    EXPECT_EQ(scene.netHits, 0);

    scalar farthest = 0;
    for (const auto& [id, i] : scene.places())
    {
        const scalar distance = std::abs(before.at(id).x() - Impact::x0);
        if (id < Impact::bedSize && woken.count(id))
        {
            farthest = std::max(farthest, distance);
        }
        else if (id < Impact::bedSize)
        {
            EXPECT_GT(distance, 10*Impact::dx) << "slept below the impact";
            EXPECT_EQ(P.r[i], before.at(id)) << "moved in its sleep";
        }
    }
    const scalar moved = scene.largestDisplacement(before);
    const scalar expected = displacementWithoutSleep();
    std::printf
    (
        "woken up to %.2f m from the impact; the bed moved by up to %.2f dx,"
        " without sleep by %.2f dx\n",
        farthest, moved/Impact::dx, expected/Impact::dx
    );
    EXPECT_LT(farthest, 0.3);
    EXPECT_GT(expected, Impact::dx);
    EXPECT_NEAR(moved, expected, 0.1*expected);
}

TEST(impact, bitsDoNotDependOnTheNumberOfThreads)
{
    const auto result = [](const int threads)
    {
        const Threads set(threads);
        Impact scene;
        scene.run(scene.acousticStep(), 340);
        EXPECT_GT(scene.asleep(), 0);
        EXPECT_GT(scene.particles.watching().size(), 0);
        auto state = scene.state();
        const vector M = scene.sleep().momentum();
        state[-1] = {M.x(), M.y(), scene.sleep().energy()};
        return state;
    };
    const auto one = result(1);
    EXPECT_EQ(one, result(2));
    EXPECT_EQ(one, result(3));
}

// A restart in the midst of it goes on as if there had been none
struct restartAfter : testing::TestWithParam<label>
{};

TEST_P(restartAfter, goesOnAsIfThereHadBeenNone)
{
    const label steps = GetParam();
    const TestCase dir;
    Impact whole;
    whole.boundaries.setDepths(whole.particles);
    const scalar dt = whole.acousticStep();
    whole.run(dt, steps);
    writeState(whole.particles, 1, dir.dir()/"1", {});
    whole.writeSleep(dir.dir()/"1");
    const label then = whole.asleep();
    EXPECT_GT(then, 100);
    EXPECT_LT(then, whole.particles.granular().size() - 100);
    whole.run(dt, 200);

    SleepScene again(Impact::text(), Impact::dx);
    ASSERT_TRUE(readState(dir.dir()/"1", again.particles));
    again.boundaries.setDepths(again.particles);
    again.startSleep("sleep {}", Impact::text(), dir.dir()/"1");
    again.index = whole.index - 200;
    EXPECT_EQ(again.asleep(), then);
    again.run(dt, 200);
    EXPECT_NE(again.asleep(), then);
    EXPECT_TRUE(again.state() == whole.state());
}

// 449: the first step decides
INSTANTIATE_TEST_SUITE_P
(
    impact, restartAfter, testing::Values(449, 450, 456),
    testing::PrintToStringParamName()
);

// A state that is written at every step
TEST(impact, isSeenHoweverOftenTheStateIsWritten)
{
    Impact scene;
    const scalar dt = scene.acousticStep();
    label most = 0;
    for (label k = 0; k < label(0.18/dt); ++k)
    {
        scene.step(dt);
        scene.scheme.neighbourhood().reset();
        most = std::max(most, scene.asleep());
    }
    EXPECT_GT(most, 0.9*Impact::bedSize);
    EXPECT_LT(scene.asleep(), most - 100);
}

} // namespace sph
