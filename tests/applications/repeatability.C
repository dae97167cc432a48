// The same case gives the same bytes: after a restart, and on any number of
// threads.
#include "applications/AppCase.H"

using namespace sph;

namespace
{

const wordList stateFiles{"granular.vtp", "walls.vtp", "uniform/time"};

// The files of a time, which must be there
std::map<word, std::string> stateOf(const AppCase& where, const word& time)
{
    std::map<word, std::string> state;
    for (const word& file : stateFiles)
    {
        EXPECT_TRUE(where.has(time + '/' + file)) << time << '/' << file;
        state[file] = where.text(time + '/' + file);
    }
    return state;
}

void expectSame
(
    const std::map<word, std::string>& a, const std::map<word, std::string>& b
)
{
    for (const word& file : stateFiles)
    {
        EXPECT_TRUE(a.at(file) == b.at(file)) << file;
    }
}

void expectRestartIsExact(const AppCase& where)
{
    where.succeed("setParticles");
    where.succeed("granularFoamSPH");
    const auto half = stateOf(where, "0.01"), end = stateOf(where, "0.02");
    EXPECT_FALSE(half.at("granular.vtp") == end.at("granular.vtp"));

    where.remove("0.02");
    const Outcome outcome = where.succeed("granularFoamSPH");
    EXPECT_FALSE(contains(outcome.text, "Time = 0.005"));
    expectSame(stateOf(where, "0.01"), half);
    expectSame(stateOf(where, "0.02"), end);
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
    where.set("system/controlDict", "writeFormat", "ascii");
    expectRestartIsExact(where);
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
