#include "support/Scene.H"

#include <gtest/gtest.h>

namespace sph
{

namespace
{

constexpr scalar dx = 0.05;

// A scene whose fields a test sets by hand
std::unique_ptr<TestScene> scene(CaseText text = CaseText())
{
    text.boundary = "bed { type noSlip; points ((0 0 0) (0.5 0 0)); }";
    auto s = std::make_unique<TestScene>
    (
        text, dx, squareLattice({0, 0}, 10, 6, dx)
    );
    s->scheme.initialise();
    return s;
}

const char* fluid =
    "rheology muI; mus 0.4; mu2 0.6; I0 0.3; d 1e-3; rhos 2600;"
    "regularisation cap; etaMax 2;";

} // namespace

// T = [-(p + q) 1 + s]/rho^2, without s where a pairwise operator makes the
// viscous force
TEST(scheme, forcesTakePressureBulkViscosityAndShear)
{
    for (const char* operators : {"stressDivergence", "Cleary", "Morris"})
    {
        CaseText text;
        text.rheology = fluid;
        text.viscousScheme = std::string("viscousScheme ") + operators + ';';
        const auto s = scene(text);
        Particles& P = s->particles;
        const label i = 34;
        P.rho[i] = 1700;
        P.p[i] = 900;
        P.q[i] = -150;
        P.s.set(i, (tensor() << 40, -30, -30, -40).finished());
        s->scheme.stress();
        s->scheme.extrapolateStress();
        tensor sigma = -750*tensor::Identity();
        if (operators == std::string("stressDivergence"))
        {
            sigma += P.s[i];
        }
        EXPECT_LT((P.T[i]*1700*1700 - sigma).norm(), 1e-9) << operators;
        // so does the wall, with its own density
        const label w = P.walls().begin + 5;
        EXPECT_NEAR
        (
            P.T.xx[w]*P.rho[w]*P.rho[w],
            -P.p[w] - P.q[w]
          + (operators == std::string("stressDivergence") ? P.s.xx[w] : 0),
            1e-9
        );
    }
}

TEST(scheme, continuityTakesDivergenceAndDiffusion)
{
    const auto s = scene();
    Particles& P = s->particles;
    const label i = 34;
    P.rho[i] = 1600;
    P.div[i] = 0.3;
    P.rhoDot[i] = 70;
    s->scheme.correctMaterial(0.01);
    EXPECT_NEAR(P.rho[i], 1600 + 0.01*(70 - 1600*0.3), 1e-11);
    EXPECT_NEAR(P.V[i], P.m[i]/P.rho[i], 1e-17);
}

TEST(scheme, pressureIsThatOfTheEquationOfState)
{
    const auto s = scene();
    Particles& P = s->particles;
    const label i = 34;
    P.rho[i] = 1.01*CaseText::rho0;
    P.div[i] = -1e-3;
    s->scheme.pressure();
    EXPECT_NEAR(P.p[i], 0.01*s->material.eos().K(), 1e-8);
    const scalar h = 1.3*dx, c = s->material.eos().c();
    EXPECT_NEAR(P.q[i], CaseText::rho0*c*h*1e-3, 1e-10);
}

// At rest and alone, every particle falls
TEST(scheme, withoutNeighboursOnlyGravityActs)
{
    CaseText text;
    TestScene s(text, dx, {{0, 0}, {1, 0}, {0, 2}});
    s.scheme.initialise();
    const scalar dt = 1e-3;
    s.run(dt, 10);
    for (label i = 0; i < 3; ++i)
    {
        EXPECT_LT((s.particles.U[i] - 10*dt*text.g).norm(), 1e-14);
        EXPECT_EQ(s.particles.rho[i], CaseText::rho0);
    }
}

TEST(scheme, anElasticLawNeedsItsStressInTheForces)
{
    CaseText text;
    text.viscousScheme = "viscousScheme Cleary;";
    try
    {
        TestScene s(text, dx);
        FAIL() << "no error";
    }
    catch (const IOError& error)
    {
        EXPECT_NE(error.block().find("stressDivergence"), std::string::npos);
        EXPECT_NE(error.file().find("sphSchemes"), std::string::npos);
    }
}

TEST(scheme, numbersOfTheKernelAndTheListsAreChecked)
{
    CaseText text;
    text.kernel = "kernel cubicSpline; hByDx 0.5;";
    EXPECT_THROW(TestScene(text, dx), IOError);
    text = CaseText();
    text.solution = "integrator symplecticEuler; skin -0.1;";
    EXPECT_THROW(TestScene(text, dx), IOError);
    text.solution = "integrator RungeKutta; skin 0.2;";
    EXPECT_THROW(TestScene(text, dx), IOError);
}

} // namespace sph
