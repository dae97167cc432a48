// Sleepers wake by stress: where the forces on them have been out of balance.
#include "scheme/SleepScene.H"

#include <gtest/gtest.h>

#include <algorithm>

namespace sph
{

namespace
{

constexpr scalar dx = 0.005, H = 12*dx, g = 9.81;

// A layer at rest whose left half is awake; it is held there without velocity,
// while its pressure changes
struct Pressed : SleepScene
{
    const scalar dt = acousticStep();
    scalar factor = 1;      // of the pressure on the left
    scalar imbalance;

    static CaseText text()
    {
        CaseText text;
        text.equationOfState =
            "equationOfState linear; linearCoeffs { KFactor 100; H 0.06; }";
        text.boundary =
            "tank { type freeSlip; points"
            " ((0 0.15 0) (0 0 0) (0.2 0 0) (0.2 0.15 0)); }";
        return text;
    }

    explicit Pressed(const scalar imbalance = 0.08)
    :
        SleepScene
        (
            text(), dx, squareLattice({0, 0}, 40, 12, dx),
            "imbalance " + std::to_string(imbalance) + ';'
        ),
        imbalance(imbalance)
    {
        hydrostatic(g, H);
        scheme.initialise();
        for (label i = 0; i < particles.granular().end; ++i)
        {
            particles.asleep[i] = particles.r.x[i] > 0.1;
            particles.Umean.set(i, {0, 0});
        }
        scheme.neighbourhood().reset();
        hold();
    }

    // The state of those that are awake, and the forces that follow from it.
    // They move enough to stay awake, but not to wake others.
    void hold()
    {
        Particles& P = particles;
        const scalar K = material.eos().K();
        for (label i = 0; i < P.awake().end; ++i)
        {
            P.U.set(i, {0, 0});
            P.Umean.set(i, {1.5*0.01*v(), 0});
            P.rho[i] =
                CaseText::rho0
               *(1 + factor*CaseText::rho0*g*(H - P.r.y[i])/K);
        }
        scheme.updatePairs();
        scheme.extrapolateVelocity();
        scheme.gradients();
        scheme.pressure();
        scheme.stress();
        scheme.extrapolateStress();
        scheme.forces(dt);
    }

    // Largest acceleration of those that watch, relative to imbalance v^2/h
    scalar load() const
    {
        const Particles& P = particles;
        const scalar limit = imbalance*v()*v()/scheme.kernel().h();
        scalar largest = 0;
        for (label i = P.watching().begin; i < P.watching().end; ++i)
        {
            largest = std::max(largest, P.a[i].norm());
        }
        return largest/limit;
    }

    // Raises the pressure on the left until the load is as given
    void pressTo(const scalar aim)
    {
        for (label k = 0; k < 2000 && load() < aim; ++k)
        {
            factor += 0.002;
            hold();
        }
        EXPECT_GE(load(), aim);
    }

    // Sleepers that wake within some times tau. Every so many steps it is as
    // if the state had been written.
    label wokenWithin(const scalar times, const label writeInterval = 100000)
    {
        const label before = asleep();
        for (label k = 0; k < label(times*tau()/dt); ++k)
        {
            if (k % writeInterval == 0)
            {
                scheme.neighbourhood().reset();
            }
            updateSleep(dt);
            if (asleep() < before)
            {
                break;
            }
            hold();
        }
        return before - asleep();
    }
};

} // namespace

TEST(sleepersUnderStress, sleepOnAtRest)
{
    Pressed scene;
    ASSERT_GT(scene.particles.watching().size(), 24);
    ASSERT_GT(scene.asleep(), 200);
    EXPECT_LT(scene.load(), 0.3);
    EXPECT_EQ(scene.wokenWithin(20), 0);
}

// d Umean/dt = a - Umean/tau tends to a tau: a load of 1 is the limit
TEST(sleepersUnderStress, wakeAboveTheLimit)
{
    Pressed scene;
    scene.pressTo(1.2);
    std::printf
    (
        "pressure beside the sleepers %.3f of that at rest\n", scene.factor
    );
    EXPECT_GT(scene.wokenWithin(4), 0);

    // Those beside the ones that are awake, not those far away
    const Particles& P = scene.particles;
    for (label i = 0; i < P.granular().end; ++i)
    {
        EXPECT_TRUE(P.asleep[i] || P.r.x[i] < 0.1 + 10*dx);
    }
}

TEST(sleepersUnderStress, wakeHoweverOftenTheStateIsWritten)
{
    for (const label writeInterval : {1, 3, 10})
    {
        Pressed scene;
        scene.pressTo(1.2);
        EXPECT_GT(scene.wokenWithin(4, writeInterval), 0) << writeInterval;
    }
}

TEST(sleepersUnderStress, sleepOnBelowTheLimit)
{
    Pressed scene;
    scene.pressTo(0.85);
    EXPECT_EQ(scene.wokenWithin(20), 0);
}

// A push that is over soon does not wake them
TEST(sleepersUnderStress, haveToBePushedForAWhile)
{
    Pressed scene;
    scene.pressTo(1.5);
    EXPECT_EQ(scene.wokenWithin(0.3), 0);
    scene.factor = 1;
    scene.hold();
    EXPECT_EQ(scene.wokenWithin(10), 0);
}

// A weight that grows slowly, within 30 tau, wakes them at the limit
TEST(sleepersUnderStress, wakeUnderASlowlyGrowingLoad)
{
    Pressed probe;
    probe.pressTo(1);
    const scalar limit = probe.factor;

    Pressed scene;
    const label before = scene.asleep();
    const scalar rate = (limit - 1)/(30*scene.tau());
    while (scene.asleep() == before && scene.factor < 1 + 2*(limit - 1))
    {
        scene.updateSleep(scene.dt);
        scene.factor += rate*scene.dt;
        scene.hold();
    }
    EXPECT_LT(scene.asleep(), before);
    EXPECT_NEAR((scene.factor - 1)/(limit - 1), 1, 0.1);
}

TEST(sleepersUnderStress, imbalanceIsTheLimit)
{
    for (const scalar imbalance : {0.04, 0.16})
    {
        Pressed below(imbalance), above(imbalance);
        below.pressTo(0.85);
        above.pressTo(1.2);
        EXPECT_EQ(below.wokenWithin(10), 0) << imbalance;
        EXPECT_GT(above.wokenWithin(4), 0) << imbalance;
    }
}

} // namespace sph
