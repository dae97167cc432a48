#include "../runTime/TestCase.H"
#include "scheme/SoundSpeedColumn.H"

#include <gtest/gtest.h>

namespace sph
{

using namespace soundSpeedColumn;

TEST(soundSpeed, staysWhereTheEntriesDoNotAskForIt)
{
    Column column("KFactor 100; H 0.4;");
    column.particles.U.set(3, {50, 0});
    EXPECT_EQ(column.heard(0), "");
    EXPECT_EQ(column.heard(10), "");
    EXPECT_EQ(column.K(), column.K0);
}

TEST(soundSpeed, staysWhereItIsRight)
{
    Column column("adaptive yes; KFactor 100; H 0.1;");
    for (label k = 0; k < 20; ++k)
    {
        EXPECT_EQ(column.heard(k*column.window()), "");
    }
    EXPECT_EQ(column.K(), column.K0);
}

TEST(soundSpeed, risesAtOnceWithThePressure)
{
    Column column("adaptive yes; KFactor 200; H 0.01;");
    EXPECT_CONTAINS(column.heard(0), "Sound speed 4.42945 -> ");
    EXPECT_GT(column.KByK(H), 0.95);
    EXPECT_LT(column.KByK(H), 1.1);
}

TEST(soundSpeed, risesAtOnceWithTheSpeed)
{
    Column column("adaptive yes; KFactor 100; H 0.1;");
    const scalar U = 1.7;
    for (label i = 100; i < 110; ++i)
    {
        column.particles.U.set(i, {0.6*U, -0.8*U});
    }
    column.follow(0);
    const scalar mach = U/column.material.eos().c();
    EXPECT_LE(mach, 0.1);
    EXPECT_GT(mach, 0.1/std::sqrt(1.1) - 1e-12);
}

// At once, however far
TEST(soundSpeed, fallsToTheGreatestNeedOfAWindow)
{
    for (const char* height : {"0.4", "10"})
    {
        Column column
        (
            std::string("adaptive yes; KFactor 100; H ") + height + ';'
        );
        const scalar window = column.window();
        for (label k = 0; k < 10; ++k)
        {
            EXPECT_EQ(column.heard(0.1*k*window), "");
        }
        EXPECT_CONTAINS(column.heard(1.1*window), "Sound speed");
        EXPECT_GT(column.KByK(H), 0.95);
        EXPECT_LT(column.KByK(H), 1.1);
    }
}

TEST(soundSpeed, fallsToTheNeedThatHasPassed)
{
    Column column("adaptive yes; KFactor 100; H 0.4;");
    const scalar U = 1.5, window = column.window(U*U/g);
    const auto setU = [&](const scalar U)
    {
        for (label i = 0; i < 10; ++i)
        {
            column.particles.U.set(i, {U, 0});
        }
    };
    column.follow(0);
    setU(U);
    column.follow(0.3*window);
    setU(0);
    EXPECT_EQ(column.heard(0.99*window), "");
    EXPECT_CONTAINS(column.heard(1.1*window), "Sound speed");
    EXPECT_LE(U/column.material.eos().c(), 0.1);
    EXPECT_GT(U/column.material.eos().c(), 0.095);
}

// Once it is right, waves of a tenth that come and go do not move it
TEST(soundSpeed, doesNotSwing)
{
    Column column("adaptive yes; KFactor 100; H 0.1;");
    Particles& P = column.particles;
    const scalarField rest = P.p;
    label changes = 0;
    for (label k = 0; k < 2000; ++k)
    {
        const scalar amplitude = k/300 % 2 == 0 ? 0.1 : 0;
        const scalar f = 0.8*(1 + amplitude*std::sin(2*pi*k/100));
        for (label i = 0; i < P.granular().end; ++i)
        {
            P.p[i] = f*rest[i];
            P.rho[i] = column.material.eos().density(P.p[i]);
        }
        changes += !column.heard(0.01*k*column.window()).empty();
    }
    EXPECT_LE(changes, 2);
}

TEST(soundSpeed, aFewSpikesDoNotCount)
{
    Column column("adaptive yes; KFactor 100; H 0.1;");
    Particles& P = column.particles;
    P.r.y[799] = 100;       // nor does a grain far above
    const auto spike = [&](const label i)
    {
        P.p[i] = 1000*rho0*g*H;
        P.U.set(i, {30, 0});
    };
    for (const label i : {5, 6, 45, 300})
    {
        spike(i);
    }
    column.follow(0);
    EXPECT_EQ(column.K(), column.K0);
    spike(301);
    column.follow(0);
    EXPECT_GT(column.K(), 10*column.K0);
}

// The pressure rho0 c U of an impact is none that c has to follow
TEST(soundSpeed, pressureCountsUpToTheWeight)
{
    Column column("adaptive yes; KFactor 100; H 0.05;");
    for (label i = 0; i < 400; ++i)
    {
        column.particles.p[i] *= 20;
    }
    column.follow(0);
    EXPECT_GE(column.KByK(H), 1);
    EXPECT_LT(column.KByK(H), 1.1);
}

TEST(soundSpeed, staysWithinBounds)
{
    Column floating("adaptive yes; KFactor 100; H 0.1;");
    for (label i = 0; i < floating.particles.granular().end; ++i)
    {
        floating.particles.p[i] = 0;
        floating.particles.rho[i] = rho0;
    }
    for (label k = 0; k < 50; ++k)
    {
        floating.follow(k);
    }
    EXPECT_GE(floating.KByK(4*dx), 1);
    EXPECT_LT(floating.KByK(4*dx), 1.3);

    Column runaway("adaptive yes; KFactor 100; H 0.1;");
    for (label i = 0; i < 50; ++i)
    {
        runaway.particles.U.set(i, {1e6, 0});
    }
    runaway.follow(0);
    EXPECT_LT(runaway.K(), 111*runaway.K0);
}

TEST(soundSpeed, stepGrowsWhenTheColumnHasFallen)
{
    CaseText text;
    text.boundary =
        "bed { type noSlip; points ((0 0 0) (1 0 0)); }"
        "middle { type symmetryPlane; point (0 0 0); normal (1 0 0); }";
    text.equationOfState =
        "equationOfState linear; adaptive yes; KFactor 100; H 0.2;";
    TestScene scene(text, dx, squareLattice({0, 0}, 6, 40, dx));
    SoundSpeed soundSpeed(scene.material.eos(), text.g, scene.particles, 0);
    scene.hydrostatic(g, 0.2);
    scene.scheme.initialise();
    const TimeStep timeStep
    (
        dictionary::fromString(""), scene.material, scene.scheme.kernel().h()
    );
    const scalar first = timeStep.stable(scene.particles);
    const Quiet quiet;
    for (scalar time = 0; time < 0.8; )
    {
        const scalar dt = 0.4*timeStep.stable(scene.particles);
        scene.step(dt);
        time += dt;
        soundSpeed.follow(time);
        scalar fastest = 0;
        for (label i = 0; i < scene.particles.granular().end; ++i)
        {
            fastest = std::max(fastest, scene.particles.U[i].norm());
        }
        EXPECT_LT(fastest, 0.2*scene.material.eos().c());
    }
    EXPECT_GT(timeStep.stable(scene.particles), 1.4*first);
}

} // namespace sph
