// Why a run stops or writes early: stopAt, function objects, signals, and a
// controlDict that is edited while it runs.
#include "runTime/TestCase.H"

#include <csignal>

namespace sph
{

namespace
{

std::string controls(const std::string& entries)
{
    return
        "endTime 1000;\ndeltaT 1e-3;\nwriteControl timeStep;\n"
        "writeInterval 100000;\n" + entries;
}

// Steps made until the loop ends, at most limit; the last step's writeTime
struct Outcome
{
    int steps;
    bool wrote;
};

Outcome run(Time& time, const int limit, const int microseconds = 0)
{
    Outcome outcome{0, false};
    while (outcome.steps < limit && time.loop(1))
    {
        ++outcome.steps;
        outcome.wrote = time.writeTime();
        ::usleep(microseconds);
    }
    return outcome;
}

struct Stopping : testing::Test
{
    TestCase testCase;
    Stopping() { testCase.mkdir("0"); }
};

} // namespace

TEST_F(Stopping, stopAtWriteNowMakesOneStepAndWrites)
{
    testCase.controlDict(controls("stopAt writeNow;"));
    Time time(testCase.dir());
    const Outcome outcome = run(time, 10);
    EXPECT_EQ(outcome.steps, 1);
    EXPECT_TRUE(outcome.wrote);
}

TEST_F(Stopping, stopAtNoWriteNowDoesNotWrite)
{
    testCase.controlDict(controls("stopAt noWriteNow;"));
    Time time(testCase.dir());
    const Outcome outcome = run(time, 10);
    EXPECT_EQ(outcome.steps, 1);
    EXPECT_FALSE(outcome.wrote);
}

// What a terminal takes for the end of the run
TEST_F(Stopping, stopTimeFollowsStopAt)
{
    const scalar none = std::numeric_limits<scalar>::infinity();
    const std::vector<std::pair<std::string, scalar>> ends
    {
        {"stopAt endTime;", 1000}, {"stopAt writeNow;", 0},
        {"stopAt nextWrite;", none},
        {"stopAt nextWrite; writeControl runTime; writeInterval 0.25;", 0.25}
    };
    for (const auto& [entries, end] : ends)
    {
        testCase.controlDict(controls(entries));
        EXPECT_EQ(Time(testCase.dir()).stopTime(), end) << entries;
    }
}

TEST_F(Stopping, stopAtNextWriteGoesOnUntilThen)
{
    testCase.controlDict(controls("stopAt nextWrite; writeInterval 4;"));
    Time time(testCase.dir());
    const Outcome outcome = run(time, 10);
    EXPECT_EQ(outcome.steps, 4);
    EXPECT_TRUE(outcome.wrote);
}

TEST_F(Stopping, stopWritesAndSaysWhy)
{
    testCase.controlDict(controls(""));
    Time time(testCase.dir());
    time.loop(1);
    EXPECT_FALSE(time.writeTime());
    testing::internal::CaptureStdout();
    time.stop("everything is at rest");
    EXPECT_CONTAINS
    (
        testing::internal::GetCapturedStdout(), "everything is at rest"
    );
    EXPECT_TRUE(time.writeTime());
    EXPECT_FALSE(time.run());
}

TEST_F(Stopping, termAndIntWriteThePresentStepAndStop)
{
    testCase.controlDict(controls(""));
    for (const int signal : {SIGTERM, SIGINT})
    {
        Time time(testCase.dir());
        run(time, 3);
        testing::internal::CaptureStdout();
        std::raise(signal);
        EXPECT_TRUE(time.writeTime());
        EXPECT_FALSE(time.run());
        EXPECT_EQ(time.index(), 3);
        EXPECT_CONTAINS
        (
            testing::internal::GetCapturedStdout(),
            signal == SIGTERM ? "Signal TERM" : "Signal INT"
        );
    }
}

TEST_F(Stopping, aSignalAfterTheWriteDecisionIsAnsweredByTheNextStep)
{
    testCase.controlDict(controls(""));
    Time time(testCase.dir());
    time.loop(1);
    EXPECT_FALSE(time.writeTime());
    std::raise(SIGTERM);
    const Outcome outcome = run(time, 10);
    EXPECT_EQ(outcome.steps, 1);
    EXPECT_TRUE(outcome.wrote);
}

TEST_F(Stopping, usr1WritesOneStepAndGoesOn)
{
    testCase.controlDict(controls(""));
    Time time(testCase.dir());
    time.loop(1);
    std::raise(SIGUSR1);
    EXPECT_TRUE(time.writeTime());
    EXPECT_TRUE(time.loop(1));
    EXPECT_FALSE(time.writeTime());
}

TEST_F(Stopping, handlersGoWithTheTime)
{
    testCase.controlDict(controls(""));
    struct sigaction before{}, after{};
    sigaction(SIGTERM, nullptr, &before);
    {
        Time time(testCase.dir());
        sigaction(SIGTERM, nullptr, &after);
        EXPECT_NE(before.sa_handler, after.sa_handler);
    }
    sigaction(SIGTERM, nullptr, &after);
    EXPECT_EQ(before.sa_handler, after.sa_handler);
}

TEST_F(Stopping, anEditedStopAtWriteNowIsNoticed)
{
    testCase.controlDict(controls("functions { probe { type probe; } }"));
    Time time(testCase.dir());
    run(time, 3);
    testCase.controlDict
    (
        controls("functions { probe { type probe; } }\nstopAt writeNow;")
    );
    testing::internal::CaptureStdout();
    const Outcome outcome = run(time, 200, 10000);
    EXPECT_CONTAINS
    (
        testing::internal::GetCapturedStdout(),
        "Re-reading object controlDict"
    );
    EXPECT_LT(outcome.steps, 100);
    EXPECT_TRUE(outcome.wrote);
    EXPECT_FALSE(time.run());
}

TEST_F(Stopping, anEditIsNotNoticedIfNotRunTimeModifiable)
{
    testCase.controlDict(controls("runTimeModifiable no;"));
    Time time(testCase.dir());
    testCase.controlDict(controls("stopAt writeNow;"));
    EXPECT_EQ(run(time, 30, 10000).steps, 30);
}

TEST_F(Stopping, aBrokenEditIsAWarningAndAMendedOneCounts)
{
    testCase.controlDict(controls(""));
    Time time(testCase.dir());
    for
    (
        const auto& [edit, message] :
        std::vector<std::pair<std::string, std::string>>
        {
            {"stopAt writeNwo;", "writeNwo"},
            {"stopAtt writeNow;", "stopAtt"},
            {"stopAt { writeNow", "controlDict"}
        }
    )
    {
        testCase.controlDict(controls(edit));
        testing::internal::CaptureStderr();
        EXPECT_EQ(run(time, 30, 10000).steps, 30) << edit;
        const std::string warned = testing::internal::GetCapturedStderr();
        EXPECT_CONTAINS(warned, "FOAM Warning") << edit;
        EXPECT_CONTAINS(warned, message) << edit;
        EXPECT_TRUE(time.run());
    }
    testCase.controlDict(controls("stopAt noWriteNow;"));
    EXPECT_LT(run(time, 200, 10000).steps, 100);
}

TEST_F(Stopping, partsOfTheOldControlDictStayAliveAfterAnEdit)
{
    testCase.controlDict(controls("functions { probe { interval 3; } }"));
    Time time(testCase.dir());
    const dictionary& old = time.controlDict().subDict("functions");
    testCase.controlDict(controls("functions { probe { interval 5; } }"));
    run(time, 30, 10000);
    EXPECT_EQ(old.subDict("probe").get<label>("interval"), 3);
    EXPECT_EQ
    (
        time.controlDict().subDict("functions").subDict("probe")
       .get<label>("interval"),
        5
    );
}

} // namespace sph
