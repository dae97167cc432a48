// A run that is killed again and again, at any moment, and goes on from what it
// has left, ends as one that was not.
#include "applications/Running.H"
#include "applications/StateFiles.H"

#include <chrono>
#include <cstdlib>
#include <random>
#include <thread>

using namespace sph;

// SPH_KILLS: how often, 10 by default
TEST(killed, endsAsARunThatWasNot)
{
    const char* given = std::getenv("SPH_KILLS");
    const label kills = given ? label(std::atol(given)) : 10;
    const word end = "0.2";

    const auto made = [&](const AppCase& where)
    {
        where.set("system/controlDict", "endTime", end);
        where.set("system/controlDict", "writeInterval", "0.0005");
        where.replace
        (
            "system/controlDict", "\nfunctions[^]*$", "\nfunctions\n{\n}\n"
        );
        where.succeed("setParticles");
    };
    const AppCase whole;
    made(whole);
    whole.succeed("granularFoamSPH");

    const AppCase where;
    made(where);
    std::mt19937 random(1);
    std::uniform_int_distribution<int> wait(20, 120);   // ms
    label killed = 0;
    for (label k = 0; k < kills; ++k)
    {
        Running run(where);
        std::this_thread::sleep_for(std::chrono::milliseconds(wait(random)));
        run.signal(SIGKILL);
        killed += run.wait() == -1;
        if (where.latestTime() == end)
        {
            where.remove(end);      // to be made once more
        }
    }
    EXPECT_GT(killed, kills/2);
    where.succeed("granularFoamSPH");
    expectSame(stateOf(where, end), stateOf(whole, end));

    for (const Time::Instant& time : Time::findTimes(where.dir()))
    {
        if (time.value > 0)
        {
            expectSame(stateOf(where, time.name), stateOf(whole, time.name));
        }
    }
}
