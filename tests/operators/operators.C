#include "operators/StressDivergence.H"
#include "support/Gradients.H"
#include "support/precision.H"
#include "support/Scene.H"

#include <gtest/gtest.h>

namespace sph
{

namespace
{

constexpr scalar dx = 0.1;

// A lattice with T set from a stress field
struct stressDivergence : testing::Test
{
    Particles P{dx};
    std::unique_ptr<Kernel> kernel = make<Kernel>("cubicSpline;", 1.3*dx);
    const scalar rho = 1500;

    template<class Stress>
    void accelerate(const Points& points, const vector& g, const Stress& sigma)
    {
        place(P, points, rho);
        for (label i = 0; i < P.granular().end; ++i)
        {
            P.T.set(i, sigma(P.r[i])/(rho*rho));
        }
        PairWalk walk(P);
        StressDivergence divergence(g);
        walkOnce(walk, divergence, *kernel);
    }
};

// A closed periodic box of particles in disorder with random fields
struct momentumOfABox : testing::Test
{
    CaseText text = CaseText::plain();
    std::unique_ptr<TestScene> scene;
    std::mt19937_64 engine{4};

    scalar number()
    {
        return std::uniform_real_distribution<scalar>(-1, 1)(engine);
    }

    void fill()
    {
        text.boundary = CaseText::periodicBox(12*dx, 10*dx);
        Points points = squareLattice({0, 0}, 12, 10, dx);
        shake(points, 0.3*dx);
        scene = std::make_unique<TestScene>(text, dx, points);
        Particles& P = scene->particles;
        for (label i = 0; i < P.granular().end; ++i)
        {
            P.U.set(i, {number(), number()});
            P.rho[i] *= 1 + 0.2*number();
            P.m[i] *= 1 + 0.3*number();
        }
        scene->scheme.updatePairs();
        scene->scheme.extrapolateVelocity();
        scene->scheme.gradients();
        scene->scheme.pressure();
        for (label i = 0; i < P.granular().end; ++i)
        {
            const scalar sxx = 1e4*number(), sxy = 1e4*number();
            P.s.set(i, (tensor() << sxx, sxy, sxy, -sxx).finished());
            P.q[i] = 1e3*number();
        }
        scene->scheme.stress();
        scene->scheme.extrapolateStress();
        scene->scheme.forces(1e-4);
    }
};

} // namespace

TEST_F(momentumOfABox, changesByGravityAlone)
{
    text.g = {3, -9.81};
    fill();
    const Particles& P = scene->particles;
    vector force = vector::Zero(), weight = vector::Zero();
    scalar scale = 0;
    for (label i = 0; i < P.granular().end; ++i)
    {
        force += P.m[i]*P.a[i];
        weight += P.m[i]*text.g;
        scale += P.m[i]*P.a[i].norm();
    }
    EXPECT_GT(scale, 3*weight.norm());
    // Terms that cancel are rounded each by itself
    EXPECT_LT((force - weight).norm(), rounding(1e-13, 1e-7)*scale);
}

TEST_F(stressDivergence, forcesOfAPairAreOpposite)
{
    place(P, {{1, 1}, {1.07, 1.05}}, 1000);
    P.T.set(0, (tensor() << 3, 1, 1, -2).finished());
    P.T.set(1, (tensor() << 1, -4, -4, 5).finished());
    PairWalk walk(P);
    StressDivergence divergence({0, 0});
    walkOnce(walk, divergence, *kernel);
    const vector r = P.r[0] - P.r[1];
    const vector expected =
        P.m[1]*kernel->F(r.norm())*(P.T[0] + P.T[1])*r;
    const scalar little = rounding(1e-13, 3e-7)*expected.norm();
    EXPECT_LT((P.a[0] - expected).norm(), little);
    EXPECT_LT((P.a[1] + expected).norm(), little);
}

TEST_F(stressDivergence, uniformStressGivesNoForceInside)
{
    accelerate
    (
        squareLattice({0, 0}, 14, 14, dx), {0, 0},
        [](const vector&)
        {
            return (tensor() << -2e3, 700, 700, -5e3).finished();
        }
    );
    for (const label i : interior(P, 3*dx))
    {
        EXPECT_LT(P.a[i].norm(), rounding(1e-10, 2e-6)*5e3/(rho*dx));
    }
    // and pushes out at a surface: compression is positive pressure
    EXPECT_LT(P.a[7].y(), 0);
    EXPECT_GT(P.a[13*14 + 7].y(), 0);
}

// a = div(sigma)/rho for a linear stress
TEST_F(stressDivergence, linearStressGivesItsDivergence)
{
    const tensor dSdx = (tensor() << 300, 500, 500, -200).finished();
    const tensor dSdy = (tensor() << -100, 400, 400, 900).finished();
    const vector g(1, -2);
    accelerate
    (
        squareLattice({0, 0}, 14, 14, dx), g,
        [&](const vector& r) { return (r.x()*dSdx + r.y()*dSdy).eval(); }
    );
    const vector exact = g + (dSdx.col(0) + dSdy.col(1))/rho;
    label checked = 0;
    for (const label i : interior(P, 3*dx))
    {
        // as exact as the plain gradient of a linear field on a lattice
        EXPECT_LT((P.a[i] - exact).norm(), 0.02*(exact - g).norm());
        ++checked;
    }
    EXPECT_GT(checked, 30);
}

TEST_F(stressDivergence, gravityAloneIsAcceleration)
{
    const vector g(1.5, -9.81);
    accelerate
    (
        squareLattice({0, 0}, 3, 3, dx), g,
        [](const vector&) { return tensor::Zero().eval(); }
    );
    for (label i = 0; i < P.granular().end; ++i)
    {
        EXPECT_EQ(P.a[i], g);
    }
}

TEST(velocityGradient, rigidRotationHasNoShearRateAndNoDivergence)
{
    Particles P(dx);
    const auto kernel = make<Kernel>("cubicSpline;", 1.3*dx);
    Points points = squareLattice({0, 0}, 14, 14, dx);
    shake(points, 0.2*dx);
    place(P, points, 1500);
    for (label i = 0; i < P.granular().end; ++i)
    {
        P.U.set(i, {-3*P.r.y[i], 3*P.r.x[i]});
    }
    calcGradients(P, *kernel, "kernelGradient;");
    // In single precision that of U, 6 at most, over dx
    const scalar little = rounding(1e-9, 8e-6);
    for (const label i : interior(P, 0.5*dx))
    {
        EXPECT_NEAR(P.gammaDot[i], 0, little);
        EXPECT_NEAR(P.div[i], 0, little);
        EXPECT_NEAR(P.gradU.yx[i], 3, little);
        EXPECT_NEAR(P.gradU.xy[i], -3, little);
    }
}

} // namespace sph
