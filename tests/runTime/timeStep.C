// The sequence of steps: growth, limits, write times and the end hit exactly.
#include "runTime/StepControls.H"

#include <cmath>

namespace sph
{

namespace
{

const char* const adjustable =
    "endTime 0.3; deltaT 1e-4; adjustTimeStep yes; maxCo 0.4;"
    "writeControl adjustable; writeInterval 0.05;";

} // namespace

TEST(timeStep, adjustableHitsEveryWriteTimeExactly)
{
    const TestCase testCase;
    Time time(testCase.dir(), controls(adjustable));
    std::vector<word> names;
    while (time.loop(0.0173))
    {
        if (time.writeTime())
        {
            names.push_back(time.timeName());
            EXPECT_EQ(time.value(), scalar(names.size())*0.05);
        }
        EXPECT_LE(time.deltaT(), 0.4*0.0173*(1 + 1e-8));
    }
    EXPECT_EQ(names, (std::vector<word>{"0.05", "0.1", "0.15", "0.2", "0.25", "0.3"}));
}

TEST(timeStep, lastStepsBeforeAWriteTimeAreEqual)
{
    const TestCase testCase;
    Time time
    (
        testCase.dir(),
        controls
        (
            "endTime 1; deltaT 0.3; adjustTimeStep yes; maxCo 1;"
            "writeControl adjustable; writeInterval 1;"
        )
    );
    std::vector<scalar> steps;
    while (time.loop(0.3))
    {
        steps.push_back(time.deltaT());
    }
    ASSERT_EQ(steps.size(), 4u);
    for (const scalar step : steps)
    {
        EXPECT_NEAR(step, 0.25, 1e-15);
    }
    EXPECT_EQ(time.value(), 1);
}

TEST(timeStep, firstStepIsDeltaTAndGrowsByTwentyPercent)
{
    const TestCase testCase;
    Time time
    (
        testCase.dir(),
        controls
        (
            "endTime 1; deltaT 1e-5; adjustTimeStep yes; maxCo 0.5;"
            "maxDeltaT 3e-4; writeControl timeStep; writeInterval 1000;"
        )
    );
    // Shortening evenly towards the far end changes a step by dt^2/end
    ASSERT_TRUE(time.loop(1e-2));
    scalar last = time.deltaT();
    EXPECT_NEAR(last, 1e-5, 1e-9);
    bool limited = false;
    for (int i = 0; i < 40; ++i)
    {
        ASSERT_TRUE(time.loop(1e-2));
        EXPECT_NEAR(time.deltaT(), std::min(1.2*last, 3e-4), 1e-6*1.2*last + 1e-7);
        EXPECT_LE(time.deltaT(), 3e-4*(1 + 1e-8));
        limited = limited || time.deltaT() > 2.999e-4;
        last = time.deltaT();
    }
    EXPECT_TRUE(limited);

    // A smaller stable step is followed at once
    time.setDeltaT(1e-4);
    EXPECT_NEAR(time.deltaT(), 0.5e-4, 1e-8);
}

TEST(timeStep, shorteningDoesNotSlowTheGrowthAfterAWrite)
{
    const TestCase testCase;
    Time time
    (
        testCase.dir(),
        controls
        (
            "endTime 2.2; deltaT 1; adjustTimeStep yes; maxCo 1;"
            "writeControl adjustable; writeInterval 1.1;"
        )
    );
    ASSERT_TRUE(time.loop(1));
    EXPECT_NEAR(time.deltaT(), 0.55, 1e-15);
    time.loop(1);
    ASSERT_TRUE(time.writeTime());
    time.loop(1.1);
    EXPECT_NEAR(time.deltaT(), 1.1, 1e-15);
}

TEST(timeStep, endTimeBetweenWriteTimesIsHitAndWritten)
{
    const TestCase testCase;
    Time time
    (
        testCase.dir(),
        controls
        (
            "endTime 0.07; adjustTimeStep yes; writeControl adjustable;"
            "writeInterval 0.05;"
        )
    );
    int writes = 0;
    while (time.loop(0.01))
    {
        writes += time.writeTime();
    }
    EXPECT_EQ(time.value(), 0.07);
    EXPECT_EQ(writes, 2);
}

TEST(timeStep, writeTimesCountFromZeroWhereverTheRunStarts)
{
    const TestCase testCase;
    testCase.mkdir("0.12");
    Time time
    (
        testCase.dir(),
        dictionary::fromString
        (
            "endTime 0.2; adjustTimeStep yes; writeControl adjustable;"
            "writeInterval 0.05;"
        )
    );
    std::vector<word> names;
    while (time.loop(0.01))
    {
        if (time.writeTime())
        {
            names.push_back(time.timeName());
        }
    }
    EXPECT_EQ(names, (std::vector<word>{"0.15", "0.2"}));
}

TEST(timeStep, fixedStepsKeepTheirLengthAndTheirNamesClean)
{
    const TestCase testCase;
    Time time
    (
        testCase.dir(),
        controls
        (
            "endTime 0.3; deltaT 1e-4; timePrecision 15;"
            "writeControl runTime; writeInterval 0.1;"
        )
    );
    std::vector<word> names;
    while (time.loop(1))
    {
        EXPECT_EQ(time.deltaT(), 1e-4);
        if (time.writeTime())
        {
            names.push_back(time.timeName());
        }
    }
    EXPECT_EQ(time.index(), 3000);
    EXPECT_EQ(names, (std::vector<word>{"0.1", "0.2", "0.3"}));
}

TEST(timeStep, fixedDeltaTAboveTheStableLimitIsAnError)
{
    const TestCase testCase;
    testCase.mkdir("0");
    testCase.controlDict
    (
        "endTime 1;\ndeltaT 1e-3;\nwriteControl timeStep;\nwriteInterval 1;\n"
    );
    Time time(testCase.dir());
    EXPECT_TRUE(time.loop(1e-3));
    const std::string error = errorOf([&]() { time.loop(4.567e-4); });
    EXPECT_CONTAINS(error, "deltaT 0.001 s");
    EXPECT_CONTAINS(error, "stable limit 0.0004567 s");
    EXPECT_CONTAINS(error, "Use adjustTimeStep yes, or deltaT <= 0.00045");
    EXPECT_CONTAINS(error, "line 2");
}

TEST(timeStep, aStableStepThatIsNoNumberIsADivergedRun)
{
    const TestCase testCase;
    Time time(testCase.dir(), controls(adjustable));
    EXPECT_CONTAINS(errorOf([&]() { time.loop(NAN); }), "diverged");
    EXPECT_CONTAINS(errorOf([&]() { time.loop(0); }), "diverged");
}

TEST(timeStep, aVanishingStepIsAnErrorAndNoEndlessLoop)
{
    const TestCase testCase;
    Time time
    (
        testCase.dir(),
        dictionary::fromString
        (
            "startFrom startTime; startTime 1; endTime 2; adjustTimeStep yes;"
            "writeControl timeStep; writeInterval 1;"
        )
    );
    EXPECT_CONTAINS(errorOf([&]() { time.loop(1e-20); }), "too small");
}

TEST(timeStep, timePrecisionRisesWhereNamesWouldCoincide)
{
    const TestCase testCase;
    Time time
    (
        testCase.dir(),
        dictionary::fromString
        (
            "startFrom startTime; startTime 1; endTime 2; deltaT 1e-8;"
            "writeControl timeStep; writeInterval 1; timePrecision 3;"
        )
    );
    time.loop(1);
    EXPECT_EQ(time.timeName(), "1.00000001");
    time.loop(1);
    EXPECT_EQ(time.timeName(), "1.00000002");
}

} // namespace sph
