// The start of a run: pressures of the state, K of the entries, one look.
#include "../runTime/TestCase.H"
#include "scheme/BulkModulusState.H"
#include "scheme/SoundSpeedColumn.H"

#include <gtest/gtest.h>

namespace sph
{

using namespace soundSpeedColumn;

namespace
{

const scalar weight = rho0*g*H;

// A column whose densities belong to state, after its start in a scene of
// entries
struct Started : Column
{
    TestCase dir;

    Started(const std::string& entries, const std::string& state)
    :
        Column(entries)
    {
        const Column before(state);
        particles.rho = before.particles.rho;
        BulkModulusState{before.K()}.write(dir.dir()/"0");
    }

    void start()
    {
        const Quiet quiet;
        soundSpeed.start(dir.dir()/"0");
    }

    void remove() const { std::filesystem::remove_all(dir.dir()/"0"); }

    std::string error()
    {
        return errorOf([&] { start(); });
    }

    void expectPressuresAtRest() const
    {
        for (label i = 0; i < nx*ny; ++i)
        {
            const scalar rest = rho0*g*(H - particles.r.y[i]);
            EXPECT_NEAR(pressure(i), rest, 1e-9*K());
            EXPECT_NEAR(particles.p[i], rest, 1e-9*K());
        }
    }
};

} // namespace

// Be the state of setParticles, or what the guard kept of a soft start
TEST(soundSpeedStart, pressuresOfTheStateAndKOfTheEntries)
{
    for (const char* adaptive : {"adaptive no;", "adaptive yes;"})
    {
        for (const char* H : {"0.001", "0.02", "0.1", "4"})
        {
            Started column
            (
                std::string("KFactor 100; H 0.1;") + adaptive,
                std::string("KFactor 100; H ") + H + ';'
            );
            column.start();
            EXPECT_EQ(column.K(), column.K0);
            column.expectPressuresAtRest();
        }
    }
}

TEST(soundSpeedStart, nothingIsConvertedWhereKIsTheSame)
{
    Started column("KFactor 100; H 0.2;", "KFactor 100; H 0.2;");
    const scalarField rho = column.particles.rho;
    column.start();
    EXPECT_EQ(column.particles.rho, rho);
    column.remove();
    column.start();
    EXPECT_EQ(column.particles.rho, rho);
}

TEST(soundSpeedStart, looksOnceHoweverFarTheGuess)
{
    for (const char* guess : {"0.002", "0.02", "1", "10", "1e4"})
    {
        const std::string entries =
            std::string("adaptive yes; KFactor 100; H ") + guess + ';';
        Started column(entries, entries);
        column.start();
        EXPECT_GT(column.KByK(H), 0.95);
        EXPECT_LT(column.KByK(H), 1.11);
        column.expectPressuresAtRest();
        column.follow(0);
        column.expectPressuresAtRest();
    }
}

// What will weigh counts, where nothing bears yet
TEST(soundSpeedStart, weightCountsWithoutPressure)
{
    Started column
    (
        "adaptive yes; KFactor 100; H 10;", "adaptive yes; KFactor 100; H 10;"
    );
    column.particles.rho.assign(column.particles.rho.size(), rho0);
    column.particles.p.assign(column.particles.p.size(), 0);
    column.start();
    EXPECT_GE(column.KByK(H), 1 - 1e-12);
    EXPECT_LT(column.KByK(H), 1.1);
}

TEST(soundSpeedStart, opensAWindow)
{
    Started column
    (
        "adaptive yes; KFactor 100; H 10;", "adaptive yes; KFactor 100; H 10;"
    );
    column.start();
    for (label i = 0; i < nx*ny; ++i)
    {
        column.particles.p[i] *= 0.5;
        column.particles.rho[i] = column.material.eos().density
        (
            column.particles.p[i]
        );
    }
    EXPECT_CONTAINS(column.heard(1.1*column.window()), "Sound speed");
    EXPECT_LT(column.KByK(H), 0.6);
}

TEST(soundSpeedStart, aGuessFarTooLowIsNamed)
{
    Started column
    (
        "adaptive yes; KFactor 100; H 1e-6;", "KFactor 100; H 0.1;"
    );
    const std::string error = column.error();
    EXPECT_CONTAINS(error, "Give a greater H");
    EXPECT_CONTAINS(error, "0.1 m high");
}

TEST(soundSpeedStart, pressuresOfAnotherLawAreRefused)
{
    Started column("KFactor 100; H 0.1;", "KFactor 100; H 0.1;");
    Particles& P = column.particles;
    P.p[17] += 0.009*weight;
    EXPECT_EQ(column.error(), "");
    P.p[17] += 0.02*weight;
    EXPECT_CONTAINS(column.error(), "particle 17 has p = ");
    EXPECT_CONTAINS(column.error(), "Run setParticles again");

    // Another K, and nothing that says which
    Started changed("KFactor 100; H 0.2;", "KFactor 100; H 0.1;");
    changed.remove();
    EXPECT_CONTAINS(changed.error(), "Run setParticles again");

    // A state without pressures says nothing else than its densities
    Started bare("KFactor 100; H 0.2;", "KFactor 100; H 0.1;");
    bare.remove();
    bare.particles.p.assign(bare.particles.p.size(), 0);
    EXPECT_EQ(bare.error(), "");
    EXPECT_NEAR(bare.greatestPressure(), 2*weight, 0.1*weight);
}

TEST(soundSpeedStart, pressuresBeyondKAreRefused)
{
    Started column("KFactor 100; H 0.1;", "KFactor 1e4; H 0.1;");
    Particles& P = column.particles;
    const scalar K = 100*column.K0;
    P.p[5] = 1.1*column.K0;
    P.rho[5] = rho0*(1 + P.p[5]/K);
    EXPECT_CONTAINS(column.error(), "exceed the present");
}

} // namespace sph
