#include "scheme/Doubts.H"
#include "scheme/filling.H"
#include "scheme/roughness.H"
#include "support/Lattice.H"
#include "support/Scene.H"

#include <gtest/gtest.h>

#include <functional>

namespace sph
{

namespace
{

struct doubts : testing::Test
{
    static constexpr scalar dx = 0.1, rho0 = 1500;
    Particles P{dx};
    Material material
    {
        dictionary::fromString
        (
            "rho0 1500; equationOfState linear; linearCoeffs { K 6e5; }"
            "rheology Newtonian; eta 0;"
        ),
        {0, -9.81}, dx
    };

    // c = 20 m/s; the pressures are more than 1e-4 K
    doubts()
    {
        put(squareLattice({0, 0}, 40, 30, dx));
    }

    void put(const Points& points)
    {
        place(P, points, rho0);
        for (label i = 0; i < P.granular().end; ++i)
        {
            P.p[i] = 1000;
            P.m[i] = rho0*dx*dx;
            P.V[i] = dx*dx;
        }
    }

    std::string said(const std::function<void(Doubts&)>& run)
    {
        Doubts made(P, material);
        testing::internal::CaptureStderr();
        run(made);
        return testing::internal::GetCapturedStderr();
    }

    std::string saidOfSpeed(const scalar speed, const label n)
    {
        for (label i = 0; i < n; ++i)
        {
            P.U.set(i, {0, speed});
        }
        return said([](Doubts& d) { d.look(0.5, 0); });
    }
};

label count(const std::string& text, const std::string& part)
{
    label n = 0;
    for
    (
        std::size_t at = text.find(part); at != std::string::npos;
        at = text.find(part, at + 1)
    )
    {
        ++n;
    }
    return n;
}

} // namespace

TEST_F(doubts, saysNothingOfALatticeAtRest)
{
    EXPECT_EQ(said([](Doubts& d) { d.look(0, 0); d.end(); }), "");
}

TEST_F(doubts, speedsAboveAFifthOfSound)
{
    EXPECT_EQ(saidOfSpeed(3.9, 100), "");
    EXPECT_EQ(saidOfSpeed(4.1, 6), "");
    const std::string text = saidOfSpeed(4.1, 7);
    EXPECT_NE(text.find("7 particles are faster"), std::string::npos) << text;
    EXPECT_NE(text.find("adaptive yes"), std::string::npos);
    EXPECT_EQ(count(said([](Doubts& d)
    {
        for (int i = 0; i < 100; ++i)
        {
            d.look(i, 0);
        }
    }), "Warning"), 1);
}

TEST_F(doubts, particlesThatTheNetHasCaught)
{
    EXPECT_EQ(said([](Doubts& d) { d.look(0, 1200); }), "");
    const std::string text =
        said([](Doubts& d) { d.look(0, 1201); d.look(1, 5000); });
    EXPECT_EQ(count(text, "Warning"), 1);
    EXPECT_NE(text.find("1201 times (there are 1200"), std::string::npos) << text;
}

TEST_F(doubts, pressuresThatAreLostInNoise)
{
    P.p.assign(P.p.size(), 59);
    EXPECT_EQ(said([](Doubts& d) { d.look(0, 0); }), "");
    EXPECT_NE
    (
        said([](Doubts& d) { d.look(0, 0); d.end(); }).find("1e-4 of the bulk"),
        std::string::npos
    );
}

// Of a plane there is none; of a pattern with amplitude A around p it is about
// A/p, but for what the plane follows
TEST_F(doubts, pressuresWithoutOrder)
{
    P.lambda.assign(P.lambda.size(), 1);
    const auto set = [&](const scalar amplitude)
    {
        for (label i = 0; i < P.granular().end; ++i)
        {
            const scalar sign = (i % 40 + i/40) % 2 ? 1 : -1;
            P.p[i] = 1000*(3 - P.r.y[i] + amplitude*sign);
        }
    };
    set(0);
    EXPECT_LT(*roughness(P), 1e-9);
    EXPECT_EQ(said([](Doubts& d) { d.look(0, 0); d.end(); }), "");
    set(1.5);
    const scalar rms = std::sqrt(3 + 1.5*1.5);      // of 3 - y over [0, 3]
    EXPECT_NEAR(*roughness(P), 1.5/rms, 0.15);
    EXPECT_NE
    (
        said([](Doubts& d) { d.look(0, 0); d.end(); }).find("without order"),
        std::string::npos
    );
    P.lambda.assign(P.lambda.size(), 0.5);
    EXPECT_FALSE(roughness(P)) << "nothing inside";
}

TEST_F(doubts, roomThatDensitiesDoNotSay)
{
    Points apart = squareLattice({0, 0}, 40, 30, 1.08*dx);
    shake(apart, 0.1*dx);
    put(apart);
    const std::string text = said([](Doubts& d) { d.look(0, 0); d.end(); });
    EXPECT_NE(text.find("% more room"), std::string::npos) << text;

    // As much is known to the densities
    for (label i = 0; i < P.granular().end; ++i)
    {
        P.V[i] = 1.08*1.08*dx*dx;
    }
    EXPECT_EQ(said([](Doubts& d) { d.look(0, 0); d.end(); }), "");
}

TEST_F(doubts, fillingIsThatOfTheRoom)
{
    EXPECT_NEAR(*filling(P), 1, 0.01);
    for (const scalar f : {0.95, 1.05, 1.2})
    {
        put(squareLattice({-1.3, 0.7}, 40, 30, f*dx));
        EXPECT_NEAR(*filling(P), 1/(f*f), 0.01/(f*f)) << f;
    }
    Points shaken = squareLattice({0, 0}, 40, 30, dx);
    shake(shaken, 0.4*dx);
    put(shaken);
    EXPECT_NEAR(*filling(P), 1, 0.08);
    put(squareLattice({0, 0}, 40, 2, dx));
    EXPECT_FALSE(filling(P));
}

} // namespace sph
