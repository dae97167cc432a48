#include "stabilisation/Stabilisation.H"
#include "support/Gradients.H"

#include <gtest/gtest.h>

namespace sph
{

namespace
{

constexpr scalar dx = 0.1, rho0 = 1500, K = 1e5;

struct stabilisation : testing::Test
{
    Particles P{dx};
    std::unique_ptr<EquationOfState> eos =
        make<EquationOfState>("linear; K 1e5; tension yes;", rho0, 0.0);
    std::unique_ptr<Kernel> kernel = make<Kernel>("cubicSpline;", 1.3*dx);

    // 12 by 12 particles, out of order by a fifth of dx
    stabilisation()
    {
        Points points = squareLattice({1, 1}, 12, 12, dx);
        shake(points, 0.2*dx);
        place(P, points, rho0);
    }

    template<class Density>
    void setDensity(const Density& density)
    {
        for (label i = 0; i < P.granular().end; ++i)
        {
            P.rho[i] = density(P.r[i]);
        }
        eos->correct(P.granular(), P.rho, P.p);
    }

    void apply(const std::string& text, const scalar deltaT = 0)
    {
        PairWalk walk(P);
        const auto model = make<Stabilisation>(text, walk, *eos, *kernel);
        model->setDeltaT(deltaT);
        ASSERT_TRUE(model->hasPairTerm());
        ASSERT_TRUE(model->needsGradRho());
        walkOnce(walk, *model, *kernel);
    }

    scalar noise(const unsigned seed)
    {
        std::mt19937_64 engine(seed);
        std::uniform_real_distribution<scalar> number(-1, 1);
        setDensity([&](const vector&) { return rho0*(1 + 0.01*number(engine)); });
        return 0.01*rho0;
    }
};

} // namespace

TEST_F(stabilisation, deltaSPHLeavesALinearDensityAsItIs)
{
    setDensity([](const vector& r) { return rho0 + 40*r.x() - 90*r.y(); });
    calcGradients(P, *kernel, "kernelGradient;");
    apply("deltaSPH; delta 0.1;");
    const scalar scale = 0.1*eos->c()*100*dx/kernel->h();
    label checked = 0;
    for (label i = 0; i < P.granular().end; ++i)
    {
        // At the corners the gradient itself is guarded
        bool exact = true;
        for (label j = 0; j < P.granular().end; ++j)
        {
            exact = exact
             && (
                    P.lambda[j] > 0.25
                 || (P.r[i] - P.r[j]).norm() > kernel->cutOff()
                );
        }
        if (exact)
        {
            EXPECT_NEAR(P.rhoDot[i], 0, 1e-10*scale);
            ++checked;
        }
    }
    EXPECT_GT(checked, 100);
}

TEST_F(stabilisation, deltaSPHConservesMass)
{
    const scalar amplitude = noise(3);
    for (label i = 0; i < P.granular().end; ++i)
    {
        P.V[i] = P.Vg[i] = dx*dx*(1 + 0.3*std::sin(i));
    }
    calcGradients(P, *kernel, "kernelGradient;");
    apply("deltaSPH; delta 0.1;");
    scalar sum = 0, scale = 0;
    for (label i = 0; i < P.granular().end; ++i)
    {
        sum += P.V[i]*P.rhoDot[i];
        scale += P.V[i]*std::abs(P.rhoDot[i]);
    }
    EXPECT_GT(scale, 1e-3*amplitude*eos->c()*dx);
    EXPECT_NEAR(sum/scale, 0, 1e-12);
}

// One particle heavier than the rest by d, gradients left out:
// rhoDot = 2 delta h c d sum V F
TEST_F(stabilisation, deltaSPHSpreadsALonePeak)
{
    setDensity([](const vector&) { return rho0; });
    const label peak = 6*12 + 6;
    const scalar d = 7;
    P.rho[peak] += d;
    apply("deltaSPH; delta 0.15;");
    scalar sum = 0;
    for (label j = 0; j < P.granular().end; ++j)
    {
        const scalar r = (P.r[peak] - P.r[j]).norm();
        if (j == peak)
        {
            continue;
        }
        const scalar VF = P.V[j]*kernel->F(r);
        const scalar rate = -2*0.15*kernel->h()*eos->c()*VF*d;
        EXPECT_NEAR(P.rhoDot[j], rate, 1e-9*eos->c()*d/dx);
        EXPECT_GE(P.rhoDot[j], 0);
        sum += VF;
    }
    const scalar rate = 2*0.15*kernel->h()*eos->c()*d*sum;
    EXPECT_LT(rate, 0);
    EXPECT_NEAR(P.rhoDot[peak]/rate, 1, 1e-12);
}

TEST_F(stabilisation, deltaSPHSmoothsNoise)
{
    noise(5);
    scalar before = 0, after = 0;
    for (label step = 0; step < 50; ++step)
    {
        calcGradients(P, *kernel, "kernelGradient;");
        apply("deltaSPH; delta 0.1;");
        scalar variance = 0;
        for (label i = 0; i < P.granular().end; ++i)
        {
            variance += std::pow(P.rho[i] - rho0, 2);
            P.rho[i] += 0.2*kernel->h()/eos->c()*P.rhoDot[i];
        }
        (step == 0 ? before : after) = variance;
    }
    EXPECT_LT(after, 0.4*before);
}

// Wall particles have no part in it
TEST_F(stabilisation, countsOnlyGranularNeighbours)
{
    noise(4);
    const label wall = 5*12 + 5;
    P.Vg[wall] = 0;
    for (const char* text : {"deltaSPH;", "velocityPressureCoupling;"})
    {
        P.rho[wall] = rho0;
        P.p[wall] = 1;
        calcGradients(P, *kernel, "kernelGradient;");
        apply(text, 1e-3);
        const scalarField before = P.rhoDot;
        P.rho[wall] = 1.3*rho0;
        P.p[wall] = 1e4;
        apply(text, 1e-3);
        for (label i = 0; i < P.granular().end; ++i)
        {
            if (i != wall)
            {
                EXPECT_EQ(P.rhoDot[i], before[i]) << text << ' ' << i;
            }
        }
    }
}

// Terms of the paper, one by one
TEST_F(stabilisation, couplingIsThatOfThePaper)
{
    setDensity
    (
        [](const vector& r)
        {
            return rho0*(1.05 + 0.02*std::sin(9*r.x())*std::cos(7*r.y()));
        }
    );
    calcGradients(P, *kernel, "kernelGradient;");
    const scalar sigma = 1.7, deltaT = 2e-4, cSqr = K/rho0;
    apply("velocityPressureCoupling; sigma 1.7;", deltaT);
    for (label i = 0; i < P.granular().end; ++i)
    {
        const vector gradPi = cSqr*P.gradRho[i];
        scalar compact = 0, wide = 0;
        vector N = vector::Zero();
        for (label j = 0; j < P.granular().end; ++j)
        {
            const vector r = P.r[i] - P.r[j];
            if (j == i || r.norm() >= kernel->cutOff())
            {
                continue;
            }
            const vector VgradW = P.V[j]*kernel->F(r.norm())*r;
            compact += 2*P.V[j]*kernel->F(r.norm())*(P.p[i] - P.p[j]);
            wide +=
                (cSqr*P.gradRho[j]/P.rho[j] - gradPi/P.rho[i]).dot(VgradW);
            N += VgradW;
        }
        const scalar laplacian =
            0.5*(P.L.xx[i] + P.L.yy[i])*(compact - 2*gradPi.dot(N));
        const scalar expected = P.rho[i]*sigma*deltaT
           *(
                laplacian/P.rho[i]
              - P.gradRho[i].dot(gradPi)/(P.rho[i]*P.rho[i]) - wide
            );
        EXPECT_NEAR
        (
            P.rhoDot[i], expected, 1e-10*sigma*deltaT*cSqr*rho0/(dx*dx)
        ) << i;
    }
}

TEST_F(stabilisation, couplingDampsACheckerboard)
{
    place(P, squareLattice({1, 1}, 12, 12, dx), rho0);
    for (label i = 0; i < P.granular().end; ++i)
    {
        P.rho[i] = rho0*(1.05 + ((i % 12 + i/12) % 2 == 0 ? 0.01 : -0.01));
    }
    eos->correct(P.granular(), P.rho, P.p);
    calcGradients(P, *kernel, "kernelGradient;");
    apply("velocityPressureCoupling; sigma 1;", 0.2*kernel->h()/eos->c());
    label checked = 0;
    for (const label i : interior(P, 3*dx))
    {
        const scalar deviation = P.rho[i] - 1.05*rho0;
        EXPECT_LT(P.rhoDot[i]*deviation, 0);
        // A rate of the order of sigma c/h
        EXPECT_GT
        (
            std::abs(P.rhoDot[i]/deviation), 0.1*eos->c()/kernel->h()
        );
        ++checked;
    }
    EXPECT_GT(checked, 9);
}

// What is left is of second order: -|grad p|^2 terms of the compressibility
TEST_F(stabilisation, couplingLeavesALinearPressureAsItIs)
{
    const scalar slope = 0.05*rho0;
    setDensity
    (
        [&](const vector& r) { return rho0*1.1 - slope*(r.y() - 1); }
    );
    calcGradients(P, *kernel, "kernelGradient;");
    const scalar deltaT = 0.2*kernel->h()/eos->c();
    apply("velocityPressureCoupling; sigma 1;", deltaT);
    label checked = 0;
    for (const label i : interior(P, 5*dx))
    {
        EXPECT_LT
        (
            std::abs(P.rhoDot[i]),
            2*deltaT*eos->c()*eos->c()*slope*slope/rho0
        );
        ++checked;
    }
    EXPECT_GT(checked, 0);
}

TEST_F(stabilisation, couplingFadesWithTheStepAndWithoutPressure)
{
    setDensity([](const vector& r) { return rho0*(1 + 0.1*std::sin(5*r.x())); });
    calcGradients(P, *kernel, "kernelGradient;");
    for (label i = 0; i < P.granular().end; ++i)
    {
        P.p[i] = std::max(P.p[i], 0.0);
    }
    apply("velocityPressureCoupling;", 1e-4);
    const scalarField large = P.rhoDot;
    apply("velocityPressureCoupling;", 1e-6);
    label pressed = 0;
    for (label i = 0; i < P.granular().end; ++i)
    {
        EXPECT_NEAR(P.rhoDot[i], 0.01*large[i], 1e-9*std::abs(large[i]));
        if (P.p[i] == 0)
        {
            EXPECT_EQ(large[i], 0);
        }
        else
        {
            ++pressed;
            EXPECT_NE(large[i], 0);
        }
    }
    EXPECT_GT(pressed, 20);
}

TEST_F(stabilisation, noneAsksForNothing)
{
    PairWalk walk(P);
    const auto model = make<Stabilisation>("none;", walk, *eos, *kernel);
    EXPECT_FALSE(model->hasPairTerm());
    EXPECT_FALSE(model->needsGradRho());
    EXPECT_TRUE(walk.fields().empty());
}

TEST_F(stabilisation, refusesNegativeNumbers)
{
    PairWalk walk(P);
    EXPECT_THROW
    (
        make<Stabilisation>("deltaSPH; delta -0.1;", walk, *eos, *kernel),
        IOError
    );
    EXPECT_THROW
    (
        make<Stabilisation>
        (
            "velocityPressureCoupling; sigma -1;", walk, *eos, *kernel
        ),
        IOError
    );
}

} // namespace sph
