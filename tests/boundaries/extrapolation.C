#include "support/Scene.H"

#include <gtest/gtest.h>

namespace sph
{

namespace
{

constexpr scalar dx = 0.05;

struct extrapolation : testing::Test
{
    CaseText text;
    std::unique_ptr<TestScene> scene;

    void fill
    (
        const std::string& boundary, const label nx, const label ny,
        const vector& min = vector::Zero(), const scalar jitter = 0
    )
    {
        text.boundary = boundary;
        Points points = squareLattice(min, nx, ny, dx);
        shake(points, jitter*dx);
        scene = std::make_unique<TestScene>(text, dx, points);
    }

    template<class Velocity>
    void setVelocity(const Velocity& velocity)
    {
        Particles& P = scene->particles;
        for (label i = 0; i < P.granular().end; ++i)
        {
            P.U.set(i, velocity(P.r[i]));
        }
        scene->scheme.updatePairs();
        scene->scheme.extrapolateVelocity();
    }

    // sum f V W/sum V W over the material in front of wall particle w; false
    // where there is none
    template<class Function>
    bool shepard(const label w, const Function& f, vector& result) const
    {
        const Particles& P = scene->particles;
        const Kernel& kernel = scene->scheme.kernel();
        vector sum = vector::Zero();
        scalar weight = 0;
        for (label j = 0; j < P.granular().end; ++j)
        {
            const scalar VW = P.V[j]*kernel.W((P.r[w] - P.r[j]).norm());
            sum += VW*f(j);
            weight += VW;
        }
        result = weight > 1e-12 ? vector(sum/weight) : vector::Zero();
        return weight > 1e-12;
    }
};

std::string bedOf(const std::string& type)
{
    return "bed { type " + type + "; points ((-1 0 0) (2 0 0)); }";
}

vector shear(const vector& r) { return {3*r.y() + 1, 0.4*r.x() - 0.2}; }

} // namespace

TEST_F(extrapolation, noSlipReversesTheVelocity)
{
    fill(bedOf("noSlip"), 20, 10, {0, 0}, 0.2);
    setVelocity(shear);
    const Particles& P = scene->particles;
    label facing = 0;
    for (label w = P.walls().begin; w < P.walls().end; ++w)
    {
        vector U;
        facing += shepard(w, [&](label j) { return P.U[j]; }, U);
        EXPECT_LT((P.U[w] + U).norm(), 1e-12) << w;
    }
    EXPECT_GT(facing, 40);
}

TEST_F(extrapolation, noSlipIsRelativeToAMovingWall)
{
    fill
    (
        "bed { type noSlip; points ((-1 0 0) (2 0 0)); velocity (0.5 0 0); }",
        20, 10
    );
    setVelocity([](const vector&) { return vector(2, 0); });
    const Particles& P = scene->particles;
    vector U;
    for (label w = P.walls().begin; w < P.walls().end; ++w)
    {
        if (shepard(w, [&](label j) { return P.U[j]; }, U))
        {
            EXPECT_LT((P.U[w] - vector(-1, 0)).norm(), 1e-12);
        }
    }
}

TEST_F(extrapolation, freeSlipReversesTheNormalVelocityOnly)
{
    for (const char* velocity : {"(0 0 0)", "(7 0.3 0)"})
    {
        fill
        (
            std::string("bed { type freeSlip; points ((-1 0 0) (2 0 0));")
          + " velocity " + velocity + "; }",
            20, 10, {0, 0}, 0.2
        );
        const scalar wall = velocity[1] == '0' ? 0 : 0.3;
        setVelocity(shear);
        const Particles& P = scene->particles;
        vector U;
        label facing = 0;
        for (label w = P.walls().begin; w < P.walls().end; ++w)
        {
            if (shepard(w, [&](label j) { return P.U[j]; }, U))
            {
                EXPECT_NEAR(P.U.x[w], U.x(), 1e-12);
                EXPECT_NEAR(P.U.y[w], 2*wall - U.y(), 1e-12);
                ++facing;
            }
        }
        EXPECT_GT(facing, 40);
    }
}

// (1 - beta) U, beta = min(betaMax, 1 + d_b/d_a)
TEST_F(extrapolation, MorrisLimitsTheReversal)
{
    fill
    (
        "bed { type Morris; betaMax 1.6; points ((-1 0 0) (2 0 0)); }",
        20, 10, {0, 0}, 0.2
    );
    setVelocity(shear);
    const Particles& P = scene->particles;
    label facing = 0;
    for (label w = P.walls().begin; w < P.walls().end; ++w)
    {
        vector U;
        facing += shepard
        (
            w,
            [&](label j)
            {
                const scalar beta =
                    std::min(1.6, 1 - P.r.y[w]/P.r.y[j]);
                return vector((1 - beta)*P.U[j]);
            },
            U
        );
        EXPECT_LT((P.U[w] - U).norm(), 1e-11) << w;
    }
    EXPECT_GT(facing, 40);
    EXPECT_LT(P.U.x[P.walls().begin + 30], 0);
}

// One particle at d_a sees the wall stand still at d_b = d_a
TEST_F(extrapolation, MorrisOfAUniformShearVanishesAtTheWall)
{
    text.boundary =
        "bed { type Morris; betaMax 10; points ((0 0 0) (1 0 0)); }";
    scene = std::make_unique<TestScene>
    (
        text, dx, Points{{10.5*dx, 0.5*dx}}
    );
    setVelocity([](const vector&) { return vector(1, 0); });
    const Particles& P = scene->particles;
    const label below = P.walls().begin + 10;
    ASSERT_NEAR(P.r.x[below], 10.5*dx, 1e-12);
    EXPECT_NEAR(P.U.x[below], -1, 1e-12);
    EXPECT_NEAR(P.U.x[below + 20], -3, 1e-11);
}

// Two kinds of wall within one slice of particles
TEST_F(extrapolation, everyPatchHasItsOwnRule)
{
    fill
    (
        "a { type freeSlip; points ((0 0 0) (0.25 0 0)); layers 1; }"
        "b { type noSlip; points ((0.25 0 0) (0.5 0 0)); layers 1; }",
        10, 6
    );
    setVelocity([](const vector&) { return vector(2, 1); });
    const Particles& P = scene->particles;
    ASSERT_EQ(P.walls().size(), 10 + 5) << "smooth walls have two for one";
    for (label w = P.walls().begin; w < P.walls().end; ++w)
    {
        const vector expected(P.r.x[w] < 0.25 ? 2 : -2, -1);
        EXPECT_LT((P.U[w] - expected).norm(), 1e-12) << P.r.x[w];
    }
}

TEST_F(extrapolation, pressureContinuesThatOfAColumnAtRest)
{
    const label nx = 24, ny = 16;
    const scalar H = ny*dx, g = 9.81;
    text.equationOfState =
        "equationOfState linear; linearCoeffs { KFactor 500; H 0.8; }";
    fill
    (
        "box { type noSlip; points ((0 1 0) (0 0 0) (1.2 0 0) (1.2 1 0)); }",
        nx, ny
    );
    scene->hydrostatic(g, H);
    scene->scheme.initialise();
    const Particles& P = scene->particles;
    const scalar pBottom = CaseText::rho0*g*H;
    label checked = 0;
    for (label w = P.walls().begin; w < P.walls().end; ++w)
    {
        const scalar exact =
            std::max(0.0, CaseText::rho0*g*(H - P.r.y[w]));
        vector any;
        if (shepard(w, [&](label) { return vector(1, 0); }, any))
        {
            EXPECT_NEAR(P.p[w], exact, 0.01*pBottom) << P.r[w].transpose();
            EXPECT_NEAR
            (
                P.rho[w], scene->material.eos().density(P.p[w]), 1e-9
            );
            EXPECT_NEAR(P.V[w], P.m[w]/P.rho[w], 1e-15);
            ++checked;
        }
        EXPECT_GE(P.p[w], 0);
    }
    EXPECT_GT(checked, 100);
}

// The stress of scales below the particles' does not end at a wall, either
TEST_F(extrapolation, turbulentStressContinuesAtARoughWall)
{
    text.turbulence = "turbulence Smagorinsky; SmagorinskyCoeffs { Cs 0.2; }";
    fill(bedOf("noSlip"), 20, 10);
    setVelocity([](const vector&) { return vector(0, 0); });
    Particles& P = scene->particles;
    scene->scheme.gradients();
    for (label i = 0; i < P.granular().end; ++i)
    {
        P.rho[i] = CaseText::rho0;
        P.p[i] = P.q[i] = 0;
        P.s.set(i, tensor::Zero());
        P.gradU.set(i, (tensor() << 1, 2, 3, -4).finished());
    }
    scene->scheme.stress();
    scene->scheme.extrapolateStress();
    const tensor expected = P.T[0];
    ASSERT_GT(expected.norm(), 0);
    label checked = 0;
    for (label w = P.walls().begin; w < P.walls().end; ++w)
    {
        vector any;
        if (shepard(w, [&](label) { return vector(1, 0); }, any))
        {
            // But for the pressure, which has the weight in it
            const scalar f = P.rho[w]/CaseText::rho0;
            const scalar off = 1e-9*expected.norm();
            EXPECT_NEAR(f*P.T.xy[w], expected(0, 1), off);
            EXPECT_NEAR
            (
                f*(P.T.xx[w] - P.T.yy[w]), expected(0, 0) - expected(1, 1), off
            );
            ++checked;
        }
    }
    EXPECT_GT(checked, 20);
}

TEST_F(extrapolation, stressContinuesAtARoughWallAndIsMirroredAtASmoothOne)
{
    for (const char* type : {"noSlip", "freeSlip"})
    {
        fill(bedOf(type), 20, 10);
        setVelocity([](const vector&) { return vector(0, 0); });
        Particles& P = scene->particles;
        scene->scheme.gradients();
        scene->scheme.pressure();
        tensor s, G;
        s << 300, 120, 120, -300;
        G << 1, 2, 3, -4;
        for (label i = 0; i < P.granular().end; ++i)
        {
            P.p[i] = 1000;
            P.q[i] = -40;
            P.s.set(i, s);
            P.gradU.set(i, G);
        }
        scene->scheme.stress();
        scene->scheme.extrapolateStress();
        const scalar sign = std::string(type) == "freeSlip" ? -1 : 1;
        label checked = 0;
        for (label w = P.walls().begin; w < P.walls().end; ++w)
        {
            vector any;
            if (shepard(w, [&](label) { return vector(1, 0); }, any))
            {
                EXPECT_NEAR(P.s.xx[w], 300, 1e-9);
                EXPECT_NEAR(P.s.xy[w], sign*120, 1e-9);
                EXPECT_NEAR(P.s.yy[w], -300, 1e-9);
                EXPECT_NEAR(P.q[w], -40, 1e-10);
                EXPECT_NEAR(P.gradU.xy[w], sign*2, 1e-11);
                EXPECT_NEAR(P.gradU.yx[w], sign*3, 1e-11);
                EXPECT_NEAR(P.gradU.yy[w], -4, 1e-11);
                ++checked;
            }
        }
        EXPECT_GT(checked, 40);
    }
}

TEST_F(extrapolation, aWallThatFacesNothingHasNoPressure)
{
    fill(bedOf("noSlip"), 4, 4, {0, 0.5});
    scene->hydrostatic(9.81, 1);
    scene->scheme.initialise();
    const Particles& P = scene->particles;
    for (label w = P.walls().begin; w < P.walls().end; ++w)
    {
        EXPECT_EQ(P.p[w], 0);
        EXPECT_EQ(P.U[w].norm(), 0);
        EXPECT_NEAR(P.rho[w], CaseText::rho0, 1e-9);
    }
}

} // namespace sph
