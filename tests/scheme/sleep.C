// Who falls asleep and who does not, what is taken from them, and errors.
#include "../runTime/TestCase.H"
#include "scheme/SleepScene.H"

#include <gtest/gtest.h>

namespace sph
{

namespace
{

constexpr scalar dx = 0.005, g = 9.81;

void setVelocity(TestScene& scene, const vector& U)
{
    for (label i = 0; i < scene.particles.granular().end; ++i)
    {
        scene.particles.U.set(i, U);
    }
}

// A block in the air, without any boundary
struct Thrown : SleepScene
{
    explicit Thrown(const vector& U)
    :
        SleepScene(CaseText(), dx, squareLattice({0, 0}, 7, 6, dx))
    {
        setVelocity(*this, U);
        scheme.initialise();
    }
};

// A layer on a smooth bed, without ends, that slides at a share of v
struct Sliding : SleepScene
{
    static CaseText text()
    {
        CaseText text;
        text.boundary =
            "bed { type freeSlip; points ((0 0 0) (0.06 0 0)); }"
            "ends { type periodic; point (0 0 0); translation (0.06 0 0); }";
        return text;
    }

    explicit Sliding
    (
        const scalar share, const std::string& entries = "",
        const CaseText& text = Sliding::text()
    )
    :
        SleepScene(text, dx, squareLattice({0, 0}, 12, 8, dx), entries)
    {
        hydrostatic(g, 8*dx);
        setVelocity(*this, {share*v(), 0});
        scheme.initialise();
    }
};

// Between smooth sides, denser than at rest: bounces for a while
struct Bouncing : SleepScene
{
    static CaseText text()
    {
        CaseText text;
        text.boundary =
            "tank { type freeSlip; points"
            " ((0 0.12 0) (0 0 0) (0.08 0 0) (0.08 0.12 0)); }";
        return text;
    }

    Bouncing()
    :
        SleepScene(text(), dx, squareLattice({0, 0}, 16, 14, dx))
    {
        hydrostatic(g, 1.1*14*dx);
        scheme.initialise();
    }
};

} // namespace

TEST(sleep, whatFallsNeverSleeps)
{
    for (const scalar upward : {0.0, 0.3})
    {
        Thrown scene({0, upward});
        const scalar dt = scene.acousticStep();
        const label steps = label(0.2/dt);
        label slow = 0;
        for (label k = 1; k <= steps; ++k)
        {
            scene.step(dt);
            ASSERT_EQ(scene.calm(), 0) << k*dt;
            slow += scene.particles.U[0].norm() < 0.02*scene.v();
        }
        const vector U(0, upward - g*steps*dt);
        EXPECT_LT((scene.particles.U[0] - U).norm(), 1e-10);
        // On top there was time for a decision
        EXPECT_GT(slow, upward > 0 ? 10 : 0);
    }
}

// Rows of wall particles are a little rough
TEST(sleep, whatSlidesAtConstantSpeedStaysAwake)
{
    Sliding scene(0.1);
    const scalar dt = scene.acousticStep();
    const vector before = scene.momentum();
    for (label k = 0; k < label(20*scene.tau()/dt); ++k)
    {
        scene.step(dt);
        ASSERT_EQ(scene.calm(), 0) << k*dt;
    }
    EXPECT_NEAR(scene.momentum().x()/before.x(), 1, 0.03);
    EXPECT_EQ(scene.sleep().momentum(), vector(0, 0));
    EXPECT_EQ(scene.sleep().energy(), 0);
}

TEST(sleep, whatCreepsFallsAsleepAndStops)
{
    Sliding scene(0.007);
    const scalar dt = scene.acousticStep();
    const vector before = scene.momentum();
    scene.run(dt, label(5*scene.tau()/dt));
    EXPECT_EQ(scene.asleep(), scene.particles.granular().size());
    EXPECT_EQ(scene.momentum(), vector(0, 0));
    EXPECT_NEAR(scene.sleep().momentum().x()/before.x(), 1, 0.05);
}

// Slow at present, but not of late: a mean speed above 0.01 v
TEST(sleep, slowButNotOnAverageIsAwake)
{
    Sliding scene(0.015);
    const scalar dt = scene.acousticStep();
    scene.run(dt, label(4*scene.tau()/dt));
    EXPECT_EQ(scene.asleep(), 0);
}

// dU/dt = -U g/(damping v) of those that are drowsy
TEST(sleep, whatIsDrowsyIsDragged)
{
    for (const scalar damping : {0.5, 2.0})
    {
        Sliding scene
        (
            0.1,
            "speed 0.2; mean 0.2; rest 1e-9; damping "
          + std::to_string(damping) + ';'
        );
        const scalar dt = scene.acousticStep();
        const label steps = label(2*scene.tau()/dt);
        scene.run(dt, steps);
        EXPECT_EQ(scene.particles.asleep[0], 0.5);
        const scalar before = scene.momentum().x();
        scene.run(dt, steps);
        const scalar expected =
            std::exp(-steps*dt*g/(damping*scene.v()));
        EXPECT_NEAR(scene.momentum().x()/before, expected, 0.02);
        EXPECT_EQ(scene.asleep(), 0);
    }
}

TEST(sleep, entriesAreTheThresholds)
{
    const auto asleepAfter = [](const std::string& entries, scalar share)
    {
        Sliding scene(share, entries);
        const scalar dt = scene.acousticStep();
        scene.run(dt, label(10*scene.tau()/dt));
        return scene.asleep() > 0;
    };
    EXPECT_TRUE(asleepAfter("speed 0.1; mean 0.1;", 0.09));
    EXPECT_FALSE(asleepAfter("speed 0.1; mean 0.08;", 0.09));
    EXPECT_FALSE(asleepAfter("speed 0.08; mean 0.1;", 0.09));
    EXPECT_FALSE(asleepAfter("speed 0.002; mean 0.1;", 0.005));
    // The mean has not forgotten the start
    EXPECT_FALSE(asleepAfter("speed 0.2; mean 0.1; period 1.5;", 0.005));
}

// v = c/sqrt(KFactor) = sqrt(g H), however stiff the material is, and c/10
// where K is given
TEST(sleep, speedsAreSharesOfThoseOfTheFlow)
{
    const std::string K = std::to_string(100*CaseText::rho0*g*0.1);
    const scalar v = std::sqrt(g*0.1);
    for
    (
        const std::string& stiffness :
        {std::string("KFactor 1600; H 0.1;"), "K " + K + ';'}
    )
    {
        for (const scalar share : {0.007, 0.03})
        {
            CaseText text = Sliding::text();
            text.equationOfState =
                "equationOfState linear; linearCoeffs {" + stiffness + '}';
            Sliding scene(0, "", text);
            setVelocity(scene, {share*v, 0});
            const scalar dt = scene.acousticStep();
            scene.run(dt, label(1.5*v/g/dt));
            EXPECT_EQ(scene.asleep() > 0, share < 0.01)
                << stiffness << ' ' << share;
        }
    }
}

// What those that are awake lose to sleep and drag, and the impulse
// sum m a dt of the forces on those that watch
TEST(sleep, addsUpWhatItTakes)
{
    Bouncing scene;
    const scalar dt = scene.acousticStep();
    const Particles& P = scene.particles;
    vector taken(0, 0), impulse(0, 0);
    scalar energy = 0, largest = 0;
    for (label k = 0; k < 5000 && P.awake().size() > 0; ++k)
    {
        scene.move(dt);
        for (label i = P.watching().begin; i < P.watching().end; ++i)
        {
            impulse += dt*P.m[i]*P.a[i];
        }
        taken += scene.momentum();
        energy += scene.kineticEnergy();
        scene.updateSleep(dt);
        taken -= scene.momentum();
        energy -= scene.kineticEnergy();
        scene.evaluate(dt);

        largest = std::max
        (
            {largest, scene.momentumScale(), taken.norm(), impulse.norm()}
        );
        ASSERT_LT
        (
            (scene.sleep().momentum() - taken - impulse).norm(),
            1e-10*largest
        );
        ASSERT_NEAR(scene.sleep().energy(), energy, 1e-10);
    }
    EXPECT_EQ(scene.asleep(), P.granular().size());
    EXPECT_GT(energy, 1e-5);
    EXPECT_GT(taken.norm(), 1e-4);
    EXPECT_GT(impulse.norm(), 1e-3);
    EXPECT_EQ(scene.netHits, 0);
}

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

TEST(sleep, errorsNameFileAndEntry)
{
    const auto refused = [](const std::string& solution, const CaseText& text)
    {
        TestScene scene(text, dx);
        place(scene.particles, {{0, 0}}, CaseText::rho0);
        return errorOf
        (
            [&]
            {
                const dictionary dict =
                    dictionary::fromString(solution, "system/sphSolution");
                const dictionary none;
                const Sleep sleep
                (
                    dict, {text.g, none, none}, scene.particles,
                    scene.scheme.neighbourhood(), scene.material.eos(), 0.01
                );
                dict.refuseUnused();
            }
        );
    };
    EXPECT_EQ(refused("sleep {}", CaseText()), "");
    EXPECT_EQ(refused("", CaseText::plain()), "");
    EXPECT_EQ
    (
        refused
        (
            "sleep { speed 0.02; mean 0.01; rest 0.002; imbalance 0.08;"
            " period 0.1; damping 0.05; }",
            CaseText()
        ),
        ""
    );

    const std::string noGravity = refused("sleep {}", CaseText::plain());
    EXPECT_CONTAINS(noGravity, "Without gravity");
    EXPECT_CONTAINS(noGravity, "system/sphSolution");
    EXPECT_CONTAINS(noGravity, "sleep");

    for
    (
        const char* entry :
        {"speed", "mean", "rest", "imbalance", "period", "damping"}
    )
    {
        for (const char* value : {"-0.1", "0", "fast", "[0 1 -1 0 0 0 0] 1"})
        {
            const std::string text = refused
            (
                "\nsleep\n{\n" + std::string(entry) + ' ' + value + ";\n}\n",
                CaseText()
            );
            EXPECT_CONTAINS(text, "system/sphSolution") << value;
            EXPECT_CONTAINS(text, entry) << value;
            EXPECT_CONTAINS(text, "line 4") << value;
        }
    }

    const std::string unknown =
        refused("sleep\n{\nperiods 0.1;\n}\n", CaseText());
    EXPECT_CONTAINS(unknown, "system/sphSolution");
    EXPECT_CONTAINS(unknown, "periods");
    EXPECT_CONTAINS(unknown, "did you mean 'period'");

    for (const char* value : {"yes", "no", "", "(a b)", "0.02"})
    {
        const std::string text = refused
        (
            "skin 0.2;\nsleep " + std::string(value) + ";\n", CaseText()
        );
        EXPECT_CONTAINS
        (
            text, "Entry 'sleep' must be a dictionary: sleep { }"
        );
        EXPECT_CONTAINS(text, "system/sphSolution");
        EXPECT_CONTAINS(text, "line 2");
    }
}

// What is faster than a fifth of v flows
TEST(sleep, thresholdsHaveLimits)
{
    const auto refused = [](const std::string& entries)
    {
        return errorOf
        (
            [&]
            {
                SleepScene
                (
                    CaseText(), dx, squareLattice({0, 0}, 2, 2, dx), entries
                );
            }
        );
    };
    const std::pair<const char*, const char*> limits[]
    {
        {"speed", "0.2"}, {"mean", "0.2"}, {"imbalance", "1"}, {"period", "10"}
    };
    for (const auto& [entry, limit] : limits)
    {
        const std::string start = '\n' + std::string(entry) + ' ';
        EXPECT_EQ(refused(start + limit + ';'), "");
        const std::string error = refused(start + limit + "1;");
        EXPECT_CONTAINS(error, "greater than 0 and at most " + word(limit));
        EXPECT_CONTAINS(error, entry);
        EXPECT_CONTAINS(error, "line 2");
    }
    EXPECT_EQ(refused("damping 1000;"), "");
    EXPECT_EQ(refused("rest 0.02;"), "");
    EXPECT_EQ(refused("speed 0.2; rest 0.2;"), "");
    for (const char* entries : {"\nrest 0.03;", "\nspeed 0.001;"})
    {
        const std::string error = refused(entries);
        EXPECT_CONTAINS(error, "Entry 'rest' is ");
        EXPECT_CONTAINS(error, " but must be at most speed, ");
        EXPECT_CONTAINS(error, "line 2");
    }
}

} // namespace sph
