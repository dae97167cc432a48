// When the state is written: by steps, by the clock, by work.
#include "runTime/StepControls.H"

namespace sph
{

TEST(writeControl, timeStepControlCountsSteps)
{
    const TestCase testCase;
    Time time
    (
        testCase.dir(),
        controls("endTime 1; deltaT 0.1; writeControl timeStep; writeInterval 3;")
    );
    std::vector<std::int64_t> indices;
    while (time.loop(1))
    {
        if (time.writeTime())
        {
            indices.push_back(time.index());
        }
    }
    EXPECT_EQ(indices, (std::vector<std::int64_t>{3, 6, 9, 10}));
    EXPECT_EQ(time.index(), 10);
}

TEST(writeControl, clockTimeControlWaitsForTheClock)
{
    const TestCase testCase;
    Time time
    (
        testCase.dir(),
        controls
        (
            "endTime 1; deltaT 1e-3; writeControl clockTime; writeInterval 0.05;"
        )
    );
    time.loop(1);
    EXPECT_FALSE(time.writeTime());
    ::usleep(60000);
    time.loop(1);
    EXPECT_TRUE(time.writeTime());
    time.loop(1);
    EXPECT_FALSE(time.writeTime());
}

TEST(writeControl, cpuTimeControlWaitsForWork)
{
    const TestCase testCase;
    Time time
    (
        testCase.dir(),
        controls("endTime 1; deltaT 1e-3; writeControl cpuTime; writeInterval 0.05;")
    );
    time.loop(1);
    const scalar begin = time.cpuTime();
    ::usleep(60000);
    ASSERT_LT(time.cpuTime() - begin, 0.05);
    while (time.cpuTime() - begin < 0.06)
    {}
    time.loop(1);
    EXPECT_TRUE(time.writeTime());
}

} // namespace sph
