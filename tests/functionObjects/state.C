// What function objects remember, written and read again.
#include "TestRun.H"

using namespace sph;

namespace
{

struct functionObjectState : testing::Test
{
    TestRun run;
    Time runTime
    {
        run.dir.dir(),
        dictionary::fromString
        (
            "endTime 1; deltaT 0.01; writeControl timeStep; writeInterval 3;"
            "functions"
            "{"
            "    s { type stopWhenAtRest; L0 0.1; H0 0.1; }"
            "    r { type runout; profileInterval 3; }"
            "    w { type fieldMinMax; fields (U); executeControl writeTime;"
            "        executeInterval 2; }"
            "}"
        )
    };
    const std::string file = "0.05/uniform/functionObjects";

    FunctionObjects objects()
    {
        return FunctionObjects
        (
            runTime.controlDict(),
            Scene
            {
                run.dir.dir(), "0", run.g, heaps::rho0, run.particles
            }
        );
    }

    std::string errorOfReading()
    {
        return errorOf
        (
            [&] { objects().read(run.dir.dir()/"0.05", runTime); }
        );
    }
};

} // namespace

TEST_F(functionObjectState, isReadAsItWasWritten)
{
    FunctionObjects first = objects();
    first.execute(runTime, true);
    for (label k = 0; k < 7; ++k)
    {
        runTime.loop(1);
        first.execute(runTime);
    }
    first.write(run.dir.dir()/"0.05");
    const std::string written = run.dir.text(file);
    for (const char* entry : {"nextSample", "fronts", "heights", "calls"})
    {
        EXPECT_CONTAINS(written, entry);
    }

    FunctionObjects second = objects();
    second.read(run.dir.dir()/"0.05", runTime);
    second.write(run.dir.dir()/"0.05");
    EXPECT_EQ(run.dir.text(file), written);
}

TEST_F(functionObjectState, whatIsCutShortIsRefused)
{
    objects().write(run.dir.dir()/"0.05");
    const std::string whole = run.dir.text(file);
    EXPECT_EQ(errorOfReading(), "");
    for (std::size_t end = 0; end + 3 < whole.size(); end += 9)
    {
        run.dir.write(file, whole.substr(0, end));
        EXPECT_CONTAINS(errorOfReading(), "FATAL IO ERROR") << end;
    }
}

// One that is new begins anew, one that is gone is gone
TEST_F(functionObjectState, belongsToTheOnesThatAreThere)
{
    run.dir.write(file, "other { period 3; } count 1;");
    EXPECT_EQ(errorOfReading(), "");
    run.dir.write(file, "r { period 3; calls 2; more 1; } count 1;");
    EXPECT_CONTAINS(errorOfReading(), "'more'");
    std::filesystem::remove_all(run.dir.dir()/"0.05");
    EXPECT_EQ(errorOfReading(), "");
}
