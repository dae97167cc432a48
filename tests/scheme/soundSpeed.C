#include "scheme/SoundSpeed.H"

#include "../runTime/TestCase.H"
#include "deposit/Energies.H"
#include "scheme/timeStep.H"
#include "support/Scene.H"

#include <gtest/gtest.h>

namespace sph
{

namespace
{

constexpr scalar dx = 0.005, g = 9.81, rho0 = CaseText::rho0;
constexpr label nx = 40, ny = 20;
constexpr scalar H = ny*dx;

// A column of 800 particles and height H at rest, of which 4 are the few
struct Column : TestScene
{
    SoundSpeed soundSpeed;
    TimeStep timeStep;
    const scalar K0;

    explicit Column
    (
        const std::string& entries, const word& law = "linear",
        const std::string& end = "0.4"
    )
    :
        TestScene
        (
            text(entries, law, end), dx, squareLattice({0, 0}, nx, ny, dx)
        ),
        soundSpeed(material.eos(), {0, -g}, particles, 0),
        timeStep(dictionary::fromString(""), material, scheme.kernel().h()),
        K0(material.eos().K())
    {
        const EquationOfState& eos = material.eos();
        for (label i = 0; i < particles.granular().end; ++i)
        {
            particles.p[i] = rho0*g*(H - particles.r.y[i]);
            particles.rho[i] = eos.density(particles.p[i]);
        }
    }

    static CaseText text
    (
        const std::string& entries, const word& law, const std::string& end
    )
    {
        CaseText text;
        text.boundary =
            "bed { type noSlip; points ((0 0 0) (" + end + " 0 0)); }"
            "middle { type symmetryPlane; point (0 0 0); normal (1 0 0); }"
            "end { type symmetryPlane; point (0.2 0 0); normal (-1 0 0); }";
        text.equationOfState = "equationOfState " + law + ';' + entries;
        return text;
    }

    scalar K() const { return material.eos().K(); }

    // K over its value for a height
    scalar KByK(const scalar height) const
    {
        return K()/(material.eos().KFactor()*rho0*g*height);
    }

    // 4 Hs/c
    scalar window() const
    {
        const EquationOfState& eos = material.eos();
        return 4*eos.K()/(eos.KFactor()*rho0*g)/eos.c();
    }

    void follow(const scalar time)
    {
        const Quiet quiet;
        soundSpeed.follow(time);
    }

    // What one look says
    std::string heard(const scalar time)
    {
        std::ostringstream text;
        auto* buffer = std::cout.rdbuf(text.rdbuf());
        soundSpeed.follow(time);
        std::cout.rdbuf(buffer);
        return text.str();
    }

    // A run with the stable step
    scalar go(scalar time, const scalar endTime)
    {
        while (time < endTime)
        {
            const scalar dt = 0.4*timeStep.stable(particles);
            step(dt);
            time += dt;
            follow(time);
        }
        return time;
    }
};

// Pressure of particle i for its density
scalar pressure(const Column& column, const label i)
{
    return column.material.eos().pressure(column.particles.rho[i]);
}

struct soundSpeed : testing::TestWithParam<word>
{};

} // namespace

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

// In half at most at the end of every window, and never too low
TEST(soundSpeed, fallsToTheGreatestNeedOfAWindow)
{
    Column column("adaptive yes; KFactor 100; H 0.4;");
    const scalar window = column.window();
    for (label k = 0; k < 10; ++k)
    {
        column.follow(0.099*k*window);
    }
    EXPECT_EQ(column.K(), column.K0);
    column.follow(window);
    EXPECT_LT(column.K(), 0.55*column.K0);
    EXPECT_GT(column.K(), 0.5*column.K0);
    column.follow(window + 1.01*column.window());
    EXPECT_GT(column.KByK(H), 0.95);
    EXPECT_LT(column.KByK(H), 1.2);
}

TEST(soundSpeed, fallsToTheNeedThatHasPassed)
{
    Column column("adaptive yes; KFactor 100; H 0.4;");
    const scalar U = 1.5, window = column.window();
    column.follow(0);
    for (label i = 0; i < 10; ++i)
    {
        column.particles.U.set(i, {U, 0});
    }
    column.follow(0.3*window);
    for (label i = 0; i < 10; ++i)
    {
        column.particles.U.set(i, {0, 0});
    }
    EXPECT_CONTAINS(column.heard(window), "Sound speed");
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

// p, s and positions stay; rho, V, G, c and the step follow
TEST_P(soundSpeed, pressureStaysWhereKChanges)
{
    for (const char* height : {"0.4", "0.02"})
    {
        Column column
        (
            std::string("adaptive yes; KFactor 100; H ") + height + ';',
            GetParam()
        );
        Particles& P = column.particles;
        column.scheme.updatePairs();
        column.scheme.extrapolateStress();
        const label apart = 33, wall = P.walls().begin + 10;
        P.rho[apart] = 0.98*rho0;
        P.s.set(50, (tensor() << 40, -30, -30, -40).finished());
        column.material.eos().correct(P.granular(), P.rho, P.p);
        ASSERT_GT(P.p[wall], 100);
        const scalarField p = P.p, rho = P.rho;
        const scalar step = column.timeStep.stable(P);

        column.follow(1.01*column.window());
        const scalar f = column.K()/column.K0;
        EXPECT_GT(std::abs(f - 1), 0.3);
        for (label i = 0; i < P.granular().end; ++i)
        {
            EXPECT_NEAR(pressure(column, i), p[i], 1e-13*column.K0);
            EXPECT_EQ(P.V[i], P.m[i]/P.rho[i]);
            EXPECT_EQ(P.Vg[i], P.V[i]);
        }
        EXPECT_EQ(P.rho[apart], 0.98*rho0);
        EXPECT_EQ(P.s.xy[50], -30);
        EXPECT_NE(P.rho[0], rho[0]);
        EXPECT_EQ(P.p[wall], p[wall]);
        EXPECT_EQ(P.rho[wall], column.material.eos().density(p[wall]));
        EXPECT_EQ(P.V[wall], P.m[wall]/P.rho[wall]);
        EXPECT_EQ(P.Vg[wall], 0);

        const Material& material = column.material;
        EXPECT_NEAR(material.rheology().G(), 0.5*material.eos().K(), 1e-9);
        EXPECT_NEAR(material.eos().c(), std::sqrt(column.K()/rho0), 1e-12);
        EXPECT_NEAR(column.timeStep.stable(P), step/std::sqrt(f), 1e-9*step);
    }
}

INSTANTIATE_TEST_SUITE_P
(
    all, soundSpeed, testing::Values("linear", "Tait"),
    [](const auto& info) { return info.param; }
);

TEST(soundSpeed, elasticEnergyChangesByLittle)
{
    Column column("adaptive yes; KFactor 100; H 0.2;");
    column.scheme.initialise();
    const Energies before(column.particles, {0, -g}, rho0);
    column.follow(1.01*column.window());
    const Energies after(column.particles, {0, -g}, rho0);
    EXPECT_EQ(after.kinetic, before.kinetic);
    EXPECT_EQ(after.potential, before.potential);
    EXPECT_NEAR
    (
        after.elastic/before.elastic, column.K0/column.K(), 0.01
    );
    EXPECT_LT(after.elastic, before.potential/300);
}

// Nothing stirs where the sound speed of a column at rest is halved
TEST(soundSpeed, columnStaysAtRest)
{
    Column column("adaptive yes; KFactor 100; H 0.4;", "linear", "0.2");
    column.scheme.initialise();
    column.go(0, 0.5);
    EXPECT_LT(column.KByK(H), 1.25);
    const Particles& P = column.particles;
    scalar fastest = 0, error = 0;
    for (label i = 0; i < P.granular().end; ++i)
    {
        const scalar rest = rho0*g*(H - P.r.y[i]);
        fastest = std::max(fastest, P.U[i].norm());
        error = std::max(error, std::abs(P.p[i] - rest));
    }
    EXPECT_LT(fastest, 1e-3*std::sqrt(g*H));
    EXPECT_LT(error, 0.01*rho0*g*H);
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

TEST(soundSpeed, densitiesOfATimeBelongToItsK)
{
    const TestCase dir;
    Column stiff("adaptive yes; KFactor 100; H 0.4;");
    stiff.soundSpeed.write(dir.dir()/"1");

    // One that follows takes K over, one that does not keeps the pressure
    Column follows("adaptive yes; KFactor 100; H 0.1;");
    Column constant("KFactor 100; H 0.1;");
    for (Column* column : {&follows, &constant})
    {
        const Quiet quiet;
        column->particles.rho = stiff.particles.rho;
        column->soundSpeed.read(dir.dir()/"1");
        for (label i = 0; i < nx*ny; ++i)
        {
            EXPECT_NEAR(pressure(*column, i), stiff.particles.p[i], 1e-8);
        }
    }
    EXPECT_EQ(follows.K(), stiff.K());
    EXPECT_EQ(follows.particles.rho, stiff.particles.rho);
    EXPECT_EQ(constant.K(), constant.K0);

    const scalarField rho = constant.particles.rho;
    constant.soundSpeed.write(dir.dir()/"2");
    constant.soundSpeed.read(dir.dir()/"2");
    constant.soundSpeed.read(dir.dir()/"none");
    EXPECT_EQ(constant.particles.rho, rho);
}

TEST(soundSpeed, brokenStateIsNamed)
{
    const TestCase dir;
    Column column("adaptive yes; KFactor 100; H 0.4;");
    for (const char* text : {"", "K 0;", "K 1e5; windowRungs 3;"})
    {
        dir.write("1/uniform/equationOfState", text);
        const std::string error =
            errorOf([&] { column.soundSpeed.read(dir.dir()/"1"); });
        EXPECT_CONTAINS(error, "1/uniform/equationOfState");
    }
}

} // namespace sph
