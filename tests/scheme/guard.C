#include "../runTime/TestCase.H"
#include "io/caseIO.H"
#include "scheme/Guard.H"
#include "support/Scene.H"

#include <gtest/gtest.h>

#include <limits>

namespace sph
{

namespace
{

struct guard : testing::Test
{
    Quiet quiet;
    Particles P{0.1};
    const scalar cP = 20, rho0 = 1500;
    Material material
    {
        dictionary::fromString
        (
            "rho0 1500; equationOfState linear; linearCoeffs { K 6e5; }"
            "rheology Newtonian; eta 0;"
        ),
        {0, -9.81}, 0.1
    };

    guard() { place(P, squareLattice({0, 0}, 6, 5, 0.1), rho0); }

    Guard made(const std::string& domain = "") const
    {
        return Guard(dictionary::fromString(domain), P, material);
    }

    // What is said after an accident at particle 7
    std::string accident(const std::function<void(Particles&)>& spoil)
    {
        const TestCase dir;
        dir.mkdir("0");
        Time runTime
        (
            dir.dir(),
            dictionary::fromString
            (
                "startFrom latestTime; stopAt endTime; endTime 1; deltaT 0.01;"
                "adjustTimeStep no; writeControl timeStep; writeInterval 1;"
            )
        );
        Guard guard = made();
        P.U.set(7, {1, 2});
        guard.keep(P, 0.25);
        P.U.set(7, {3, 4});
        spoil(P);
        const scalar keptK = material.eos().K();
        material.eos().setK(0.9*keptK);
        EXPECT_FALSE(guard.sound(P));
        const std::string text = errorOf([&] { guard.check(P, runTime); });

        Particles written;
        EXPECT_TRUE(dir.has("0.25/granular.vtp"));
        readState(dir.dir()/"0.25", written);
        EXPECT_EQ(written.granular().size(), 30);
        EXPECT_EQ(written.U[7], vector(1, 2)) << "the last good state";
        EXPECT_EQ
        (
            dictionary::fromFile
            (
                dir.dir()/"0.25"/"uniform"/"equationOfState"
            ).get<scalar>("K"),
            keptK
        );
        EXPECT_CONTAINS(text, "particle 7");
        EXPECT_CONTAINS(text, "0.25");
        EXPECT_CONTAINS(text, "What to try");
        return text;
    }
};

} // namespace

TEST_F(guard, letsAGoodStatePass)
{
    EXPECT_TRUE(made().sound(P));
    P.U.set(3, {19, 0});
    P.rho[4] = 0.5*rho0;
    EXPECT_TRUE(made().sound(P));
}

TEST_F(guard, seesThePresentSoundSpeed)
{
    const Guard guard = made();
    const auto soundAt = [&](const scalar factor)
    {
        material.eos().setK(factor*6e5);
        return guard.sound(P);
    };
    P.U.set(3, {19, 0});
    EXPECT_TRUE(soundAt(1));
    EXPECT_FALSE(soundAt(0.9));
    P.U.set(3, {0, 0});
    P.a.set(4, {0, 9.5*cP*cP/0.1});
    EXPECT_TRUE(soundAt(1));
    EXPECT_FALSE(soundAt(0.9));
}

TEST_F(guard, findsNumbersThatAreNotFinite)
{
    const scalar nan = std::numeric_limits<scalar>::quiet_NaN();
    const scalar inf = std::numeric_limits<scalar>::infinity();
    for (const scalar bad : {nan, inf, -inf})
    {
        for
        (
            scalarField* field :
            {&P.r.x, &P.r.y, &P.U.x, &P.U.y, &P.rho, &P.a.x, &P.a.y}
        )
        {
            for (const label i : {0, 17, 29})
            {
                const scalar good = (*field)[i];
                const Guard guard = made();
                (*field)[i] = bad;
                EXPECT_FALSE(guard.sound(P));
                (*field)[i] = good;
            }
        }
    }
    EXPECT_TRUE(made().sound(P));
}

TEST_F(guard, saysWhatIsNotFiniteAndKeepsTheLastGoodState)
{
    EXPECT_CONTAINS
    (
        accident([](Particles& P) { P.U.x[7] = NAN; }), "not finite"
    );
}

TEST_F(guard, saysWhoLeftTheDomain)
{
    const std::string text =
        accident([](Particles& P) { P.r.y[7] = -300; });
    EXPECT_CONTAINS(text, "domain");
    EXPECT_CONTAINS(text, "-300");
}

TEST_F(guard, saysWhoIsFasterThanPressureWaves)
{
    EXPECT_CONTAINS
    (
        accident([](Particles& P) { P.U.set(7, {20, 5}); }), "speed"
    );
}

TEST_F(guard, saysWhoseDensityIsWrong)
{
    EXPECT_CONTAINS
    (
        accident([](Particles& P) { P.rho[7] = -3; }), "density is -3"
    );
}

TEST_F(guard, knowsTheDomainOfTheCase)
{
    const Guard guard = made("domain { min (-1 -1 0); max (2 1 0); }");
    P.r.set(2, {1.9, 0.9});
    EXPECT_TRUE(guard.sound(P));
    P.r.set(2, {2.1, 0.9});
    EXPECT_FALSE(guard.sound(P));
    EXPECT_THROW
    (
        made("domain { min (-1 -1 0); max (0.5 1 0); }"), IOError
    );
}

} // namespace sph
