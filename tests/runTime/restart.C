// A restart makes the same steps as the uninterrupted run, bit for bit.
#include "runTime/TestCase.H"

#include <cmath>
#include <map>

namespace sph
{

namespace
{

struct Step
{
    scalar value;
    scalar deltaT;
    bool write;
    word name;

    bool operator==(const Step& other) const
    {
        return
            value == other.value && deltaT == other.deltaT
         && write == other.write && name == other.name;
    }
};

using Steps = std::map<std::int64_t, Step>;     // by index

// A stable step that depends on the time alone, as it would on the state; once
// so small that time names need more digits
scalar stableAt(const scalar t)
{
    const scalar pinched = std::abs(t - 0.2) < 1e-5 ? 1e-4 : 1;
    return pinched*0.011*(1 + 0.7*std::sin(37*t) + 0.2*std::sin(611*t));
}

// Runs until lastIndex (or the end) and writes every state that is due
void run(const TestCase& testCase, Steps& steps, const std::int64_t lastIndex)
{
    Time time(testCase.dir());
    while (time.index() < lastIndex && time.loop(stableAt(time.value())))
    {
        steps[time.index()] =
        {
            time.value(), time.deltaT(), time.writeTime(), time.timeName()
        };
        if (time.writeTime())
        {
            std::filesystem::create_directories(time.timePath());
            time.writeState(time.timePath());
            time.wroteState();
        }
    }
}

void expectSameSteps(const std::string& controlDict)
{
    const TestCase whole, parts;
    for (const TestCase* testCase : {&whole, &parts})
    {
        testCase->mkdir("0");
        testCase->controlDict(controlDict);
    }
    Steps expected, steps;
    run(whole, expected, 1000000);
    ASSERT_GT(expected.size(), 100u);

    // Killed again and again, each time some steps after a state was written
    for (int kill = 40; kill < 1000; kill += 47)
    {
        run(parts, steps, kill);
    }
    run(parts, steps, 1000000);
    EXPECT_EQ(steps.size(), expected.size());
    EXPECT_TRUE(steps == expected);
}

} // namespace

TEST(restart, adjustableWriteTimes)
{
    expectSameSteps
    (
        "endTime 1; deltaT 1e-4; adjustTimeStep yes; maxCo 0.4;"
        "writeControl adjustable; writeInterval 0.03;"
    );
}

TEST(restart, adjustedStepsWithRunTimeControl)
{
    expectSameSteps
    (
        "endTime 1; deltaT 1e-4; adjustTimeStep yes; maxCo 0.4;"
        "writeControl runTime; writeInterval 0.03; timePrecision 4;"
    );
}

TEST(restart, adjustedStepsWithTimeStepControl)
{
    expectSameSteps
    (
        "endTime 1; deltaT 1e-4; adjustTimeStep yes; maxCo 0.4;"
        "writeControl timeStep; writeInterval 7; timeFormat scientific;"
    );
}

TEST(restart, fixedSteps)
{
    expectSameSteps
    (
        "endTime 0.5; deltaT 0.00071; writeControl runTime;"
        "writeInterval 0.013;"
    );
}

TEST(restart, growthGoesOnWhereItWas)
{
    const TestCase testCase;
    testCase.mkdir("0");
    testCase.controlDict
    (
        "endTime 1; deltaT 1e-6; adjustTimeStep yes; writeControl timeStep;"
        "writeInterval 5;"
    );
    Steps steps;
    run(testCase, steps, 5);
    run(testCase, steps, 6);
    EXPECT_NEAR(steps[6].deltaT/steps[5].deltaT, 1.2, 1e-4);
}

TEST(restart, uniformTimeIsADictionaryWithFullPrecision)
{
    const TestCase testCase;
    testCase.mkdir("0");
    testCase.controlDict
    (
        "endTime 1; deltaT 0.3333333333333333; writeControl timeStep;"
        "writeInterval 1;"
    );
    Time time(testCase.dir());
    time.loop(1);
    time.writeState(time.timePath());
    time.wroteState();
    const dictionary dict =
        dictionary::fromFile(time.timePath()/"uniform"/"time");
    EXPECT_TRUE(dict.isDict("FoamFile"));
    EXPECT_EQ(dict.get<scalar>("value"), time.value());
    EXPECT_EQ(dict.get<scalar>("deltaT"), 0.3333333333333333);
    EXPECT_EQ(dict.get<label>("index"), 1);
    EXPECT_EQ(dict.get<word>("name"), "0.333333");
}

TEST(restart, aRenamedFolderIsAFreshStart)
{
    const TestCase testCase;
    testCase.mkdir("0");
    testCase.controlDict
    (
        "endTime 1; deltaT 0.25; writeControl timeStep; writeInterval 1;"
    );
    {
        Time time(testCase.dir());
        time.loop(1);
        time.writeState(time.timePath());
        time.wroteState();
    }
    std::filesystem::remove_all(testCase.dir()/"0");
    std::filesystem::rename(testCase.dir()/"0.25", testCase.dir()/"0");
    const Time time(testCase.dir());
    EXPECT_EQ(time.value(), 0);
    EXPECT_EQ(time.index(), 0);
}

} // namespace sph
