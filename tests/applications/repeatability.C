// The same case gives the same bytes: after a restart, and on any number of
// threads.
#include "applications/StateFiles.H"
#include "io/caseIO.H"

using namespace sph;

namespace
{

void expectRestartIsExact
(
    const AppCase& where, const word& halfTime = "0.01",
    const word& endTime = "0.02"
)
{
    where.succeed("setParticles");
    where.succeed("granularFoamSPH");
    const auto half = stateOf(where, halfTime), end = stateOf(where, endTime);
    EXPECT_FALSE(half.at("granular.vtp") == end.at("granular.vtp"));

    where.remove(endTime);
    const Outcome outcome = where.succeed("granularFoamSPH");
    EXPECT_FALSE(contains(outcome.text, "\nTime = 0.00"));
    expectSame(stateOf(where, halfTime), half);
    expectSame(stateOf(where, endTime), end);
}

label sleepers(const AppCase& where, const word& time)
{
    Particles particles;
    readState(where.dir()/time, particles);
    const scalar* asleep = particles.asleep.data();
    return label
    (
        std::count(asleep, asleep + particles.granular().end, 1)
    );
}

} // namespace

TEST(repeatability, restartBitForBit)
{
    expectRestartIsExact(AppCase());
}

TEST(repeatability, restartBitForBitWithOtherModels)
{
    const AppCase where;
    where.set("system/sphSolution", "integrator", "velocityVerlet");
    where.set("system/sphSchemes", "kernel", "WendlandC2");
    where.append("system/controlDict", "writeCompression on;");
    expectRestartIsExact(where);
}

TEST(repeatability, restartBitForBitFromAscii)
{
    const AppCase where;
    where.append("system/controlDict", "writeFormat ascii;");
    expectRestartIsExact(where);
}

// K falls at the start, and once more when the window closes that is open when
// the state is written
TEST(repeatability, restartBitForBitWithASoundSpeedThatFollows)
{
    const AppCase where;
    where.replace
    (
        "constant/granularProperties", "\n +KFactor [^;]*;",
        "\nadaptive yes; KFactor 4000;"
    );
    where.replace
    (
        "constant/granularProperties", "\\] 0.08748;", "] 0.2;"
    );
    expectRestartIsExact(where);
    const scalar start = 4000*1612*9.81*0.2;
    const scalar half = dictionary::fromFile
    (
        where.dir()/"0.01"/"uniform"/"equationOfState"
    ).get<scalar>("K");
    const scalar end = dictionary::fromFile
    (
        where.dir()/"0.02"/"uniform"/"equationOfState"
    ).get<scalar>("K");
    EXPECT_LT(half, 0.99*start);
    EXPECT_LT(end, 0.99*half);
}

// Some sleep when the state is written; others do when the run ends
TEST(repeatability, restartBitForBitWithSleepers)
{
    const AppCase where;
    where.set("system/setParticlesDict", "nr", "20");
    where.set("system/controlDict", "writeInterval", "0.18");
    where.set("system/controlDict", "endTime", "0.36");
    where.append("system/sphSolution", "sleep {}");
    expectRestartIsExact(where, "0.18", "0.36");
    const label half = sleepers(where, "0.18"), end = sleepers(where, "0.36");
    EXPECT_GT(half, 20);
    EXPECT_LT(half, 320);
    EXPECT_GT(end, half);
    EXPECT_TRUE(where.has("0.36/uniform/sleep"));

    // Without the dictionary all wake
    where.replace("system/sphSolution", "sleep \\{\\}", "");
    where.remove("0.36");
    where.succeed("granularFoamSPH");
    EXPECT_EQ(sleepers(where, "0.36"), 0);
}

// A gate that has lifted half of its way when the state is written, and is
// away when the run ends
TEST(repeatability, restartBitForBitWithAGate)
{
    const AppCase where;
    where.append
    (
        "constant/boundary",
        "gate { type freeSlip; points ((0.0972 0 0) (0.0972 0.1 0));"
        " motion { velocity (0 1.3 0); start 0.002; end 0.017; } }"
    );
    expectRestartIsExact(where);
    Particles start, half, end;
    readState(where.dir()/"0", start);
    readState(where.dir()/"0.01", half);
    readState(where.dir()/"0.02", end);
    const label last = start.walls().end - 1;
    EXPECT_NEAR(half.r.y[last] - start.r.y[last], 1.3*0.008, 1e-12);
    EXPECT_NEAR(end.r.y[last] - start.r.y[last], 1.3*0.015, 1e-12);

    // Another boundary does not fit the wall particles of this time
    where.replace("constant/boundary", "1\\.3", "1.4");
    where.remove("0.02");
    const Outcome outcome = where.run("granularFoamSPH");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_TRUE(says(outcome, "Run setParticles again"));
}

// What function objects remember is written, too: the run stops at the same step,
// and for the same reason, although the state is written within the window that
// it looks back
TEST(repeatability, restartBitForBitUntilItStopsByItself)
{
    const AppCase where;
    where.set("system/controlDict", "endTime", "1.1");
    where.set("system/controlDict", "writeInterval", "0.02");
    where.succeed("setParticles");
    const auto reason = [&]
    {
        const Outcome outcome = where.succeed("granularFoamSPH");
        std::smatch match;
        const std::regex regex("Stopping at time [^\n]*");
        EXPECT_TRUE(std::regex_search(outcome.text, match, regex));
        return match.str();
    };
    const std::string expected = reason();
    const word last = where.latestTime();
    ASSERT_LT(std::stod(last), 1.1);
    const auto end = stateOf(where, last);

    where.remove(last);
    EXPECT_EQ(reason(), expected);
    EXPECT_EQ(where.latestTime(), last);
    expectSame(stateOf(where, last), end);
}

TEST(repeatability, threadsDoNotChangeTheResult)
{
    const AppCase one, two;
    // More particles than one block of the thread team
    for (const AppCase* where : {&one, &two})
    {
        where->set("system/setParticlesDict", "nr", "24");
        where->succeed("setParticles");
    }
    one.succeed("granularFoamSPH", 1);
    const Outcome outcome = two.succeed("granularFoamSPH", 2);
    EXPECT_TRUE(says(outcome, "nProcs : 2"));
    expectSame(stateOf(one, "0.02"), stateOf(two, "0.02"));
}
