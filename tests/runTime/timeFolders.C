// Time folders on disk: which are times, where a run starts, purgeWrite.
#include "runTime/TestCase.H"

namespace sph
{

namespace
{

const std::string basics =
    "endTime 1;\ndeltaT 0.1;\nwriteControl timeStep;\nwriteInterval 1;\n";

word startedAt(const TestCase& testCase, const std::string& entries)
{
    testCase.controlDict(basics + entries);
    return Time(testCase.dir()).timeName();
}

void runToTheEnd(Time& time)
{
    while (time.loop(1))
    {
        if (time.writeTime())
        {
            std::filesystem::create_directories(time.timePath());
            time.writeState(time.timePath());
            time.wroteState();
        }
    }
}

std::vector<word> timeNames(const TestCase& testCase)
{
    std::vector<word> names;
    for (const Time::Instant& time : Time::findTimes(testCase.dir()))
    {
        names.push_back(time.name);
    }
    return names;
}

} // namespace

TEST(timeFolders, onlyFoldersNamedByANumberAreTimesSortedByValue)
{
    const TestCase testCase;
    for
    (
        const char* name :
        {
            "0", "0.05", "10", "9", "1e-05", "0.orig", "constant", "system",
            "VTK", "1e", "nan", "inf", "0x10", "."
        }
    )
    {
        testCase.mkdir(name);
    }
    testCase.write("7", "a file is no time");
    EXPECT_EQ
    (
        timeNames(testCase),
        (std::vector<word>{"0", "1e-05", "0.05", "9", "10"})
    );
    EXPECT_TRUE(Time::findTimes(testCase.dir()/"away").empty());
}

TEST(timeFolders, startFromChoosesTheFolder)
{
    const TestCase testCase;
    for (const char* name : {"0", "0.05", "0.5"})
    {
        testCase.mkdir(name);
    }
    EXPECT_EQ(startedAt(testCase, ""), "0.5");
    EXPECT_EQ(startedAt(testCase, "startFrom latestTime;"), "0.5");
    EXPECT_EQ(startedAt(testCase, "startFrom firstTime;"), "0");
    EXPECT_EQ
    (
        startedAt(testCase, "startFrom startTime; startTime 0.050;"), "0.05"
    );
}

TEST(timeFolders, missingStartTimeNamesTheAvailableOnes)
{
    const TestCase testCase;
    testCase.mkdir("0");
    testCase.mkdir("0.05");
    const std::string error = errorOf
    (
        [&]()
        {
            startedAt(testCase, "startFrom startTime;\nstartTime 0.04;\n");
        }
    );
    EXPECT_CONTAINS(error, "FATAL IO ERROR");
    EXPECT_CONTAINS(error, "0.04");
    EXPECT_CONTAINS(error, "Available times : 0 0.05");
    EXPECT_CONTAINS(error, "controlDict");
    EXPECT_CONTAINS(error, "line 6");
}

TEST(timeFolders, noTimeFolderSaysToRunSetParticles)
{
    const TestCase testCase;
    testCase.mkdir("0.orig");
    EXPECT_CONTAINS
    (
        errorOf([&]() { startedAt(testCase, ""); }), "setParticles"
    );
}

TEST(timeFolders, missingControlDictIsNamed)
{
    const TestCase testCase;
    EXPECT_CONTAINS
    (
        errorOf([&]() { Time time(testCase.dir()); }), "system/controlDict"
    );
}

TEST(timeFolders, endTimeBeforeTheStartIsAWarningAndNothingToDo)
{
    const TestCase testCase;
    testCase.mkdir("2");
    testCase.controlDict(basics);
    testing::internal::CaptureStderr();
    Time time(testCase.dir());
    const std::string warned = testing::internal::GetCapturedStderr();
    EXPECT_CONTAINS(warned, "FOAM Warning");
    EXPECT_CONTAINS(warned, "endTime 1");
    EXPECT_FALSE(time.run());
    EXPECT_FALSE(time.loop(1));
}

TEST(timeFolders, purgeWriteKeepsTheLastFoldersAndTheStart)
{
    const TestCase testCase;
    testCase.mkdir("0");
    testCase.controlDict(basics + "purgeWrite 2;");
    Time time(testCase.dir());
    runToTheEnd(time);
    EXPECT_EQ(timeNames(testCase), (std::vector<word>{"0", "0.9", "1"}));
    EXPECT_TRUE(testCase.has("1/uniform/time"));
}

TEST(timeFolders, purgeWriteSparesFoldersOfEarlierRuns)
{
    const TestCase testCase;
    testCase.mkdir("0");
    testCase.mkdir("0.25");
    testCase.mkdir("0.75");
    testCase.controlDict(basics + "purgeWrite 1;");
    Time time(testCase.dir());
    runToTheEnd(time);
    EXPECT_EQ
    (
        timeNames(testCase),
        (std::vector<word>{"0", "0.25", "0.75", time.timeName()})
    );
}

TEST(timeFolders, withoutPurgeWriteAllFoldersStay)
{
    const TestCase testCase;
    testCase.mkdir("0");
    testCase.controlDict(basics);
    Time time(testCase.dir());
    runToTheEnd(time);
    EXPECT_EQ(timeNames(testCase).size(), 11u);
}

} // namespace sph
