// The record of those asleep: who sleeps on after a restart.
#include "../runTime/TestCase.H"
#include "scheme/SleepBlocks.H"

#include <gtest/gtest.h>

namespace sph
{

TEST(sleep, atARestartThoseThatSleptSleepOn)
{
    const TestCase dir;
    Bouncing scene;
    const label n = scene.particles.granular().size();
    scene.runUntilAsleep(scene.acousticStep(), 8, n - 8, 1);
    const label some = scene.asleep();
    const label watching = scene.particles.watching().size();
    scene.writeSleep(dir.dir()/"1");
    scene.particles.setAwake(n, n);
    scene.startSleep("sleep {}", Bouncing::text(), dir.dir()/"1");
    EXPECT_EQ(scene.asleep(), some);
    EXPECT_EQ(scene.particles.awake().end, n - some);
    EXPECT_EQ(scene.particles.watching().size(), watching);
    EXPECT_GT(watching, 0);
}

// What they rest on must be the same; comments, the order of white space and
// how a number is written are no matter
TEST(sleep, onOtherGroundAllAreAwake)
{
    const TestCase dir;
    Bouncing scene;
    const label n = scene.particles.granular().size();
    scene.runUntilAsleep(scene.acousticStep(), 8, n - 8, 1);
    const label some = scene.asleep();
    scene.writeSleep(dir.dir()/"1");
    const scalarField asleep = scene.particles.asleep;
    const vectorField Umean = scene.particles.Umean;

    const auto wokenBy = [&](const CaseText& text, const std::string& solution)
    {
        scene.particles.asleep = asleep;
        scene.particles.Umean = Umean;
        std::ostringstream log;
        std::streambuf* before = std::cout.rdbuf(log.rdbuf());
        scene.startSleep(solution, text, dir.dir()/"1");
        std::cout.rdbuf(before);
        if (scene.asleep() == 0)
        {
            EXPECT_EQ(scene.particles.awake().end, n);
            EXPECT_EQ(scene.particles.Umean[n/2], vector(0.03*scene.v(), 0));
        }
        else
        {
            EXPECT_EQ(scene.asleep(), some);
        }
        return log.str();
    };
    const std::string start = "All particles are awake: ";

    CaseText same = Bouncing::text();
    same.rheology = "/* sand */ FoamFile { object x; }" + same.rheology;
    same.boundary += "  // a tank\n";
    same.rheology.replace(same.rheology.find("0.589"), 5, "5.89e-1");
    EXPECT_FALSE(contains(wokenBy(same, "sleep  { }"), start));

    CaseText turned = Bouncing::text();
    turned.g = {9.81, 0};
    EXPECT_CONTAINS
    (
        wokenBy(turned, "sleep {}"),
        start + "constant/g has changed since time 1\n"
    );
    CaseText smooth = Bouncing::text();
    smooth.rheology.replace(smooth.rheology.find("0.589"), 5, "0.3  ");
    EXPECT_CONTAINS
    (
        wokenBy(smooth, "sleep {}"), start + "constant/granularProperties"
    );
    CaseText rough = Bouncing::text();
    rough.boundary.replace(rough.boundary.find("freeSlip"), 8, "noSlip");
    EXPECT_CONTAINS(wokenBy(rough, "sleep {}"), start + "constant/boundary");
    EXPECT_CONTAINS
    (
        wokenBy(Bouncing::text(), "sleep { imbalance 0.04; }"),
        start + "sleep in system/sphSolution"
    );

    // Written without it, by the guard or by an earlier version
    std::filesystem::remove(dir.dir()/"1"/"uniform"/"sleep");
    EXPECT_CONTAINS
    (
        wokenBy(Bouncing::text(), "sleep {}"),
        start + "there is no 1/uniform/sleep"
    );
}

// Nor is a record of another run left there
TEST(sleep, withoutItNoRecordIsWritten)
{
    const TestCase dir;
    Bouncing scene;
    scene.writeSleep(dir.dir()/"1");
    EXPECT_TRUE(dir.has("1/uniform/sleep"));
    scene.startSleep("", Bouncing::text());
    scene.writeSleep(dir.dir()/"1");
    EXPECT_FALSE(dir.has("1/uniform/sleep"));
}

TEST(sleep, withoutTheDictionaryAndAtAStartAllAreAwake)
{
    for (const bool restart : {true, false})
    {
        const TestCase dir;
        Bouncing scene;
        const scalar dt = scene.acousticStep();
        const label n = scene.particles.granular().size();
        scene.runUntilAsleep(dt, 8, n, 1);
        scene.writeSleep(dir.dir()/"1");
        scene.startSleep
        (
            restart ? "skin 0.2;" : "sleep {}", Bouncing::text(),
            restart ? dir.dir()/"1" : ""
        );
        EXPECT_EQ(scene.asleep(), 0);
        EXPECT_EQ
        (
            scene.particles.awake().end, scene.particles.granular().end
        );
        if (restart)
        {
            scene.run(dt, label(5*scene.tau()/dt));
            EXPECT_EQ(scene.asleep(), 0);
        }
    }
}

// Nobody knows yet who has been at rest: a column that is let go falls
TEST(sleep, switchedOnAtARestartItWaits)
{
    const TestCase dir;
    Thrown scene({0, 0});
    scene.startSleep("skin 0.2;", CaseText());
    const scalar dt = scene.acousticStep(0.1);
    scene.step(dt);
    scene.writeSleep(dir.dir()/"1");
    scene.startSleep("sleep {}", CaseText(), dir.dir()/"1");
    for (label k = 0; k < label(5*scene.tau()/dt); ++k)
    {
        scene.step(dt);
        ASSERT_EQ(scene.calm(), 0) << k*dt;
    }
}

} // namespace sph
