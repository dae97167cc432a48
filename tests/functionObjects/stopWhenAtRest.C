#include "TestRun.H"

using namespace sph;

// tc of the column of TestRun is 0.1 s
static const std::string entry = "s { type stopWhenAtRest; L0 0.1; H0 0.1; }";

static void setSpeed
(
    Particles& particles, const label begin, const label end, const scalar U
)
{
    for (label i = begin; i < end; ++i)
    {
        particles.U.set(i, {U, 0});
    }
}


TEST(stopWhenAtRest, stopsWhatIsAtRestAfterItsTimeToBegin)
{
    TestRun run;
    EXPECT_NEAR(run.go(entry, 1), 0.11, 0.0101);
}


TEST(stopWhenAtRest, waitsForTheMassToBecomeSlow)
{
    TestRun run;
    const label n = run.particles.granular().size();
    const scalar end = run.go(entry, 2, [&](const scalar time)
    {
        setSpeed(run.particles, 0, n, time < 0.6 ? 0.02 : 0.005);
    });
    EXPECT_NEAR(end, 0.61, 0.0201);
}


TEST(stopWhenAtRest, doesNotStopWhileOnePercentMoves)
{
    TestRun run;
    setSpeed(run.particles, 0, 4, 0.1);     // of 400
    EXPECT_NEAR(run.go(entry, 1), 1, 1e-9);

    TestRun less;
    setSpeed(less.particles, 0, 1, 0.1);    // 0.25 % does not count
    EXPECT_LT(less.go(entry, 1), 0.2);
}


TEST(stopWhenAtRest, doesNotStopWhileTheFrontCreeps)
{
    // slow by its speed, but 2e-3 L0 in half a tc
    const auto creep = [](const scalar speed)
    {
        TestRun run;
        heaps::place(run.particles, heaps::triangle(0.2, 0.1, 0.005));
        const vectorField start = run.particles.r;
        return run.go(entry, 1, [&](const scalar time)
        {
            for (label i = 0; i < run.particles.granular().size(); ++i)
            {
                run.particles.r.x[i] = start.x[i] + speed*time;
            }
        });
    };
    EXPECT_NEAR(creep(0.004), 1, 1e-9);
    EXPECT_LT(creep(0.001), 0.2);
}


TEST(stopWhenAtRest, needsGravity)
{
    TestRun run;
    run.g = vector(0, 0);
    EXPECT_CONTAINS(errorOf([&]{ run.go(entry, 1); }), "gravity");
}
