// Walls that move: a piston, a box that travels, a gate.
#include "support/Scene.H"

#include <gtest/gtest.h>

#include <cstdio>

namespace sph
{

namespace
{

constexpr scalar dx = 0.005, g = 9.81;

// A fluid without shear stress; K in Pa
CaseText water(const std::string& K)
{
    CaseText text;
    text.rheology = "rheology Newtonian; NewtonianCoeffs { eta 0; }";
    text.equationOfState =
        "equationOfState linear; linearCoeffs { K " + K + "; }";
    return text;
}

// Corners of a closed box, and how all its walls move
std::string box(const std::string& motion = "")
{
    return "box { type noSlip;"
        " points ((0 0 0) (0.1 0 0) (0.1 0.1 0) (0 0.1 0) (0 0 0)); "
      + motion + "}";
}

} // namespace

// Slow against sound: p = K (H/(H - s) - 1), the same everywhere
TEST(piston, raisesThePressureAsTheEquationOfStateSays)
{
    CaseText text = water("1e5");
    text.g = vector::Zero();
    text.boundary =
        "tank { type freeSlip; points"
        " ((0 0.13 0) (0 0 0) (0.1 0 0) (0.1 0.13 0)); }"
        "lid { type freeSlip; points ((0.1 0.1 0) (0 0.1 0));"
        " motion { velocity (0 -0.02 0); start 0.02; end 0.12; } }";
    TestScene scene(text, dx, squareLattice({0, 0}, 20, 20, dx));
    scene.scheme.initialise();
    const scalar dt = scene.acousticStep();
    const scalar K = scene.material.eos().K();
    const Particles& P = scene.particles;
    std::printf("time [s]   p [Pa]   reference   error %%   spread %%\n");
    for (const scalar end : {0.019, 0.07, 0.12, 0.2})
    {
        while (scene.time + dt < end)
        {
            scene.step(dt);
        }
        const scalar s = 0.02*std::clamp(scene.time - 0.02, 0.0, 0.1);
        const scalar reference = K*(0.1/(0.1 - s) - 1);
        scalar mean = 0, spread = 0;
        const label n = P.granular().size();
        for (label i = 0; i < n; ++i)
        {
            mean += P.p[i]/n;
        }
        for (label i = 0; i < n; ++i)
        {
            spread += std::pow(P.p[i] - mean, 2)/n;
        }
        spread = std::sqrt(spread);
        std::printf
        (
            "%8.3f %8.1f %11.1f %9.2f %10.2f\n", scene.time, mean, reference,
            100*(mean/std::max(reference, 1.0) - 1),
            100*spread/std::max(reference, 1.0)
        );
        if (s == 0)
        {
            EXPECT_LT(mean, 1e-9*K) << "nothing moves yet";
            continue;
        }
        EXPECT_NEAR(mean/reference, 1, 0.03);
        EXPECT_LT(spread, 0.05*reference);
    }
    EXPECT_EQ(scene.netHits, 0);
    EXPECT_NEAR(P.r.y[P.walls().end - 1], 0.098 + 2.5*dx, 1e-12);
}

// A box whose walls all move as its contents do is the box at rest
TEST(aBoxThatTravels, isTheBoxAtRest)
{
    const vector U(0.7, -0.3);
    const auto result = [&](const bool moving)
    {
        CaseText text;
        text.boundary =
            moving ? box("motion { velocity (0.7 -0.3 0); end 10; }") : box();
        auto scene = std::make_unique<TestScene>
        (
            text, dx, squareLattice({0, 0}, 20, 12, dx)
        );
        // Something happens: it sloshes
        Particles& P = scene->particles;
        for (label i = 0; i < P.granular().end; ++i)
        {
            P.U.set(i, {0.4*P.r.y[i]/0.1 + (moving ? U.x() : 0),
                moving ? U.y() : 0});
        }
        scene->hydrostatic(g, 12*dx);
        scene->scheme.initialise();
        scene->run(scene->acousticStep(), 60);
        return scene;
    };
    const auto rest = result(false), moved = result(true);
    const vector shift = U*moved->time;
    std::map<std::int64_t, label> place;
    const Particles& A = rest->particles;
    const Particles& B = moved->particles;
    for (label i = 0; i < B.granular().end; ++i)
    {
        place[B.id[i]] = i;
    }
    scalar position = 0, velocity = 0, stress = 0, fastest = 0;
    for (label i = 0; i < A.granular().end; ++i)
    {
        const label j = place.at(A.id[i]);
        position = std::max(position, (B.r[j] - shift - A.r[i]).norm());
        velocity = std::max(velocity, (B.U[j] - U - A.U[i]).norm());
        stress = std::max(stress, (B.s[j] - A.s[i]).norm());
        fastest = std::max(fastest, A.U[i].norm());
    }
    std::printf
    (
        "differences: position %.1e dx, velocity %.1e m/s, stress %.1e Pa;"
        " fastest %.2f m/s\n", position/dx, velocity, stress, fastest
    );
    EXPECT_LT(position, 1e-8*dx);
    EXPECT_LT(velocity, 1e-8);
    EXPECT_LT(stress, 1e-6*CaseText::rho0*g*0.06);
    EXPECT_GT(fastest, 0.05);
    EXPECT_EQ(rest->netHits, moved->netHits);
}

// A smooth wall that moves along itself does nothing, a rough one drags
TEST(aWallThatMovesAlongItself, dragsOnlyIfItIsRough)
{
    for (const word type : {"freeSlip", "noSlip"})
    {
        CaseText text = CaseText::plain();
        text.rheology = "rheology Newtonian; NewtonianCoeffs { eta 5; }";
        text.equationOfState =
            "equationOfState linear; linearCoeffs { K 1e5; }";
        text.boundary =
            "left { type freeSlip; points ((0 0.1 0) (0 0 0)); }"
            "gate { type " + type + "; points ((0.1 -0.05 0) (0.1 0.15 0));"
            " motion { velocity (0 1 0); travel 0.03; } }";
        TestScene scene(text, dx, squareLattice({0, 0}, 20, 20, dx));
        scene.scheme.initialise();
        scene.run(scene.acousticStep(0.2), 60);
        if (type == "freeSlip")
        {
            EXPECT_LT(scene.momentumScale(), 1e-12);
        }
        else
        {
            EXPECT_GT(scene.momentum().y(), 1e-3);
        }
    }
}

// Water stands against a gate, which then goes up
TEST(gate, holdsTheWaterUntilItLifts)
{
    constexpr scalar H = 0.1, L = 0.1;
    CaseText text = water("1e5");
    text.boundary =
        "bed { type freeSlip; points ((-0.015 0 0) (0.4 0 0)); }"
        "back { type freeSlip; points ((0 0.15 0) (0 0 0)); }"
        "gate { type freeSlip; points ((0.1 0 0) (0.1 0.12 0));"
        " motion { velocity (0 1.3 0); start 0.2; travel 0.14; } }";
    TestScene scene(text, dx, squareLattice({0, 0}, 20, 20, dx));
    scene.hydrostatic(g, H);
    scene.scheme.initialise();
    const scalar dt = scene.acousticStep();
    const Particles& P = scene.particles;
    const auto count = [&](const auto& condition)
    {
        label n = 0;
        for (label i = 0; i < P.granular().end; ++i)
        {
            n += condition(P.r[i]);
        }
        return n;
    };
    while (scene.time < 0.199)
    {
        scene.step(dt);
    }
    // On the first row of its dummies, two to a spacing: rho g (H - y)
    scalar error = 0, force = 0;
    label rows = 0;
    for (label w = P.walls().begin; w < P.walls().end; ++w)
    {
        if (P.patch[w] == 2 && P.depth[w] < dx && P.r.y[w] < H)
        {
            const scalar exact = CaseText::rho0*g*(H - P.r.y[w]);
            error += std::pow(P.p[w] - exact, 2);
            force += P.p[w]*dx/2;
            ++rows;
        }
    }
    error = std::sqrt(error/rows)/(CaseText::rho0*g*H);
    const scalar exactForce = 0.5*CaseText::rho0*g*H*H;
    std::printf
    (
        "at rest: RMS error of the pressure on the gate %.2f %% of that at the"
        " base, force %.2f N/m, reference %.2f\n",
        100*error, force, exactForce
    );
    EXPECT_EQ(rows, 40);
    EXPECT_LT(error, 0.03);
    EXPECT_NEAR(force/exactForce, 1, 0.05);
    EXPECT_EQ(count([](const vector& r) { return r.x() > L - 0.2*dx; }), 0);
    EXPECT_EQ(scene.netHits, 0);
    EXPECT_LT(scene.kineticEnergy(), 1e-4*CaseText::rho0*H*H*g*H);

    // Under the gate nothing is left of it when it has gone
    scalar front = 0;
    while (scene.time < 0.4)
    {
        scene.step(dt);
    }
    for (label i = 0; i < P.granular().end; ++i)
    {
        front = std::max(front, P.r.x[i]);
    }
    // Ritter's front bounds it: 2 sqrt(g H) = 1.98 m/s
    EXPECT_GT(front, L + 0.5*0.2*std::sqrt(g*H));
    EXPECT_LT(front, L + 2*0.2*std::sqrt(g*H));
    EXPECT_EQ(count([](const vector& r) { return r.y() < 0; }), 0);
    const label last = P.walls().end - 1;
    EXPECT_NEAR(P.r.y[last], 0.26 - 0.25*dx, 1e-12);
    EXPECT_LT(P.p[last], 1e-9);
}

} // namespace sph
