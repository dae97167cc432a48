// A run that goes wrong, and a run that somebody ends: the state is there.
#include "applications/Running.H"

#include <chrono>
#include <thread>

using namespace sph;

namespace
{

// Whether a condition becomes true within 20 s
bool becomes(const std::function<bool()>& condition)
{
    for (int i = 0; i < 2000; ++i)
    {
        if (condition())
        {
            return true;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
}

// A run without end
void runForever(const AppCase& where)
{
    where.set("system/controlDict", "endTime", "1e3");
    where.set("system/controlDict", "writeInterval", "1e3");
    where.replace
    (
        "system/controlDict", "\nfunctions[^]*$", "\nfunctions\n{\n}\n"
    );
    where.succeed("setParticles");
}

bool stepped(const AppCase& where)
{
    return contains(where.text("log"), "\nTime = ");
}

// The state of the last time can be gone on from, by a step at least
void expectGoesOn(const AppCase& where)
{
    const word from = where.latestTime();
    ASSERT_NE(from, "0");
    ASSERT_NE(from, "");
    where.set("system/controlDict", "stopAt", "writeNow");
    EXPECT_TRUE(says(where.succeed("granularFoamSPH"), "\nTime = "));
    EXPECT_GT(std::stod(where.latestTime()), std::stod(from));
}

word timeOfLastGoodState(const Outcome& outcome)
{
    std::smatch match;
    const std::regex regex("state was written to time ([0-9.e+-]*)\\.");
    EXPECT_TRUE(std::regex_search(outcome.text, match, regex)) << outcome.text;
    return match[1];
}

} // namespace

TEST(safety, interruptLeavesAStateToGoOnFrom)
{
    const std::map<int, word> signals{{SIGINT, "INT"}, {SIGTERM, "TERM"}};
    for (const auto& [number, name] : signals)
    {
        const AppCase where;
        runForever(where);
        Running run(where);
        EXPECT_TRUE(becomes([&] { return stepped(where); }));
        run.signal(number);
        EXPECT_EQ(run.wait(), 0);
        EXPECT_CONTAINS
        (
            where.text("log"), "Signal " + name + ": writing time"
        );
        EXPECT_EQ(Time::findTimes(where.dir()).size(), 2u);
        expectGoesOn(where);
    }
}

TEST(safety, writeNowInTheRunningCase)
{
    const AppCase where;
    runForever(where);
    Running run(where);
    EXPECT_TRUE(becomes([&] { return stepped(where); }));
    where.set("system/controlDict", "stopAt", "writeNow");
    EXPECT_EQ(run.wait(), 0);
    EXPECT_EQ(Time::findTimes(where.dir()).size(), 2u);
    expectGoesOn(where);
}

TEST(safety, oneRunAtATimeInACase)
{
    const AppCase where;
    runForever(where);
    const Running run(where);
    EXPECT_TRUE(becomes([&] { return stepped(where); }));
    for (const char* application : {"granularFoamSPH", "setParticles"})
    {
        const Outcome second = where.run(application);
        EXPECT_EQ(second.code, 1);
        EXPECT_TRUE(says(second, "Another program is running in the case"));
        EXPECT_TRUE(says(second, where.dir().string()));
    }
    where.succeed("postRunout");
}

TEST(safety, killedRunLeavesNoHalfState)
{
    const AppCase where;
    runForever(where);
    where.set("system/controlDict", "writeInterval", "1e-3");
    Running run(where);
    EXPECT_TRUE(becomes([&] { return where.has("0.02/granular.vtp"); }));
    run.signal(SIGKILL);
    EXPECT_EQ(run.wait(), -1);
    expectGoesOn(where);
}

TEST(safety, folderWithoutParticlesIsPassedOver)
{
    const AppCase where;
    where.succeed("setParticles");
    where.succeed("granularFoamSPH");
    where.mkdir("0.03");
    where.set("system/controlDict", "endTime", "0.04");
    const Outcome outcome = where.succeed("granularFoamSPH");
    EXPECT_TRUE(says(outcome, "starting from 0.02"));
    EXPECT_TRUE(where.has("0.04/granular.vtp"));
}

TEST(safety, brokenStateIsNamed)
{
    const AppCase where;
    where.succeed("setParticles");
    where.succeed("granularFoamSPH");
    const std::string whole = where.text("0.02/granular.vtp");
    where.write("0.02/granular.vtp", whole.substr(0, whole.size()/2));
    where.set("system/controlDict", "endTime", "0.04");
    const Outcome outcome = where.run("granularFoamSPH");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_TRUE(says(outcome, "The file is broken"));
    EXPECT_TRUE(says(outcome, "0.02/granular.vtp"));
    EXPECT_TRUE(says(outcome, "Remove this time folder"));
}

TEST(safety, runawayStopsWithTheLastGoodState)
{
    const AppCase where;
    where.replace
    (
        "constant/granularProperties", "\n +KFactor [^;]*;", "\nKFactor 1e-2;"
    );
    where.succeed("setParticles");
    const Outcome outcome = where.run("granularFoamSPH");
    EXPECT_EQ(outcome.code, 1);
    for
    (
        const char* text :
        {
            "The run went wrong at time", "first particle", " at (",
            "What to try", "KFactor", "The last good state was written to"
        }
    )
    {
        EXPECT_TRUE(says(outcome, text));
    }
    EXPECT_TRUE(where.has(timeOfLastGoodState(outcome) + "/granular.vtp"));
}

TEST(safety, particleOutsideTheDomainStopsTheRun)
{
    const AppCase where;
    where.append
    (
        "system/sphSolution", "domain { min (-0.1 -0.1 0); max (0.094 1 0); }"
    );
    where.set("system/controlDict", "endTime", "0.2");
    where.succeed("setParticles");
    const Outcome outcome = where.run("granularFoamSPH");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_TRUE(says(outcome, "it left the domain"));
    EXPECT_TRUE(says(outcome, "a longer wall in constant/boundary"));
    const word time = timeOfLastGoodState(outcome);
    EXPECT_TRUE(where.has(time + "/granular.vtp"));
    EXPECT_GT(std::stod(time), 0);
    EXPECT_LT(std::stod(where.latestTime()), 0.2);
}
