// Who falls asleep and who does not, and what is taken from them.
#include "scheme/SleepBlocks.H"

#include <gtest/gtest.h>

namespace sph
{

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

} // namespace sph
