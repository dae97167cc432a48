// Sand in a tank that comes to rest sleeps, and is woken by stress.
#include "scheme/SleepScene.H"

#include <gtest/gtest.h>

namespace sph
{

namespace
{

constexpr scalar g = 9.81;

// n by n particles between smooth sides
struct Tank : SleepScene
{
    static constexpr label n = 24;
    static constexpr scalar H = 0.1, dx = H/n;

    static CaseText text()
    {
        CaseText text;
        text.boundary =
            "tank { type freeSlip; points"
            " ((0 0.15 0) (0 0 0) (0.1 0 0) (0.1 0.15 0)); }";
        return text;
    }

    // pressure: of the start, relative to that at rest
    explicit Tank(const scalar pressure, const std::string& entries = "")
    :
        SleepScene(text(), dx, squareLattice({0, 0}, n, n, dx), entries)
    {
        hydrostatic(pressure*g, H);
        scheme.initialise();
    }

    scalar weightAbove(const scalar y) const
    {
        const scalar K = material.eos().K(), rho0 = CaseText::rho0;
        return K*std::expm1(rho0*g*(H - y)/K);
    }

    // RMS differences from the weight above, relative to that at the base: of
    // the pressure, and of the vertical stress
    std::pair<scalar, scalar> errors() const
    {
        const Particles& P = particles;
        scalar p = 0, syy = 0;
        for (label i = 0; i < P.granular().end; ++i)
        {
            const scalar weight = weightAbove(P.r.y[i]);
            p += std::pow(P.p[i] - weight, 2);
            syy += std::pow(P.p[i] - P.s.yy[i] - weight, 2);
        }
        const scalar scale = P.granular().end*std::pow(weightAbove(0), 2);
        return {std::sqrt(p/scale), std::sqrt(syy/scale)};
    }

    // Until all sleep; returns the number of free-fall times
    scalar untilAsleep(const scalar limit)
    {
        const scalar tc = std::sqrt(H/g);
        const scalar t =
            runUntilAsleep(acousticStep(), n*n, n*n, limit*tc);
        EXPECT_EQ(netHits, 0);
        return t/tc;
    }
};

} // namespace

TEST(tank, atRestFallsAsleepAndStaysAsItIs)
{
    Tank scene(1);
    const scalar time = scene.untilAsleep(2);
    const auto [p, syy] = scene.errors();
    std::printf
    (
        "asleep after %.2f tc; RMS error of p %.1e, of the vertical stress"
        " %.1e of the weight\n", time, p, syy
    );
    EXPECT_GT(time, 0.1);
    EXPECT_LT(p, 0.015);
    EXPECT_LT(syy, 0.02);
    EXPECT_EQ(scene.particles.awake().size(), 0);
    EXPECT_EQ(scene.particles.watching().size(), 0);

    const auto state = scene.state();
    const vector momentum = scene.sleep().momentum();
    scene.run(scene.acousticStep(), 300);
    EXPECT_EQ(scene.state(), state);
    EXPECT_EQ(scene.sleep().momentum(), momentum);
    EXPECT_EQ(scene.momentum(), vector(0, 0));
}

// Elastic waves carry the stress rho c U = 10 rho v U: what of it is kept asleep
// falls with the speed at which particles sleep
TEST(tank, thatHasToSettleKeepsTheStressThatRestAllows)
{
    for (const scalar pressure : {0.5, 1.3})
    {
        const std::pair<const char*, scalar> settings[]
        {
            {"rest 0.02; damping 100;", 0.2}, {"", 0.05},
            {"rest 0.0002;", 0.02}
        };
        for (const auto& [entries, band] : settings)
        {
            Tank scene(pressure, entries);
            const scalar time = scene.untilAsleep(10);
            const scalar error = scene.errors().second;
            std::printf
            (
                "start %.1f of the pressure, sleep {%s}: asleep after %.2f tc,"
                " RMS error of the vertical stress %.3f of the weight\n",
                pressure, entries, time, error
            );
            EXPECT_LT(error, band);
        }
    }
}

// One particle that moves keeps some awake, not always a number of whole slices
TEST(tank, withOneThatMovesNobodyWakesAndSleepsInTurn)
{
    scalar most = 0;
    for (const std::int64_t moving : {100, 244, 300})
    {
        Tank scene(1);
        const scalar dt = scene.acousticStep();
        const auto run = [&](const label steps)
        {
            for (label k = 0; k < steps; ++k)
            {
                const label i = scene.places().at(moving);
                scene.particles.Umean.set(i, {1.5*0.01*scene.v(), 0});
                scene.step(dt);
            }
        };
        run(label(6*scene.tau()/dt));
        EXPECT_GT(scene.asleep(), 300);
        const auto rebuilds = scene.scheme.neighbourhood().rebuilds();
        run(200);
        EXPECT_EQ(scene.scheme.neighbourhood().rebuilds(), rebuilds);
        const scalar fillers = scene.calm() - scene.asleep();
        most = std::max(most, fillers/scene.particles.awake().size());
    }
    EXPECT_GT(most, 0.02);      // worth new lists, but for the slices
}

} // namespace sph
