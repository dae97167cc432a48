// A run that is killed again and again, at any moment, and goes on from what it
// has left, ends as one that was not.
#include "applications/Running.H"
#include "applications/StateFiles.H"

#include <chrono>
#include <cstdlib>
#include <random>
#include <thread>

using namespace sph;

namespace
{

constexpr label nTimes = 400;

// 400 times after the first one
void make(const AppCase& where)
{
    where.set("system/controlDict", "endTime", "0.2");
    where.set("system/controlDict", "writeInterval", "0.0005");
    where.replace
    (
        "system/controlDict", "\nfunctions[^]*$", "\nfunctions\n{\n}\n"
    );
    where.succeed("setParticles");
}

label timesOf(const AppCase& where)
{
    return label(Time::findTimes(where.dir()).size());
}

} // namespace

// SPH_KILLS: how often, 10 by default
TEST(killed, endsAsARunThatWasNot)
{
    const char* given = std::getenv("SPH_KILLS");
    const label kills = given ? label(std::atol(given)) : 10;
    ASSERT_GT(kills, 0);
    ASSERT_LE(kills, nTimes/4);

    const AppCase whole, where;
    make(whole);
    make(where);
    whole.succeed("granularFoamSPH");

    // After some progress, however fast, and at any moment of a write
    std::mt19937 random(1);
    std::uniform_int_distribution<label> progress(1, nTimes/kills - 2);
    std::uniform_int_distribution<int> moment(0, 2000);     // microseconds
    for (label k = 0; k < kills; ++k)
    {
        const label enough = timesOf(where) + progress(random);
        Running run(where);
        while (timesOf(where) < enough)
        {
            std::this_thread::yield();
        }
        std::this_thread::sleep_for(std::chrono::microseconds(moment(random)));
        run.signal(SIGKILL);
        EXPECT_EQ(run.wait(), -1);
    }
    where.succeed("granularFoamSPH");

    EXPECT_FALSE(where.hasTemporary());
    EXPECT_EQ(timesOf(where), nTimes + 1);
    for (const Time::Instant& time : Time::findTimes(where.dir()))
    {
        if (time.value > 0)
        {
            expectSame(stateOf(where, time.name), stateOf(whole, time.name));
        }
    }
}
