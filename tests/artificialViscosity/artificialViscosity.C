#include "artificialViscosity/ArtificialViscosity.H"
#include "support/Gradients.H"
#include "support/precision.H"

#include <gtest/gtest.h>

namespace sph
{

namespace
{

constexpr scalar dx = 0.1, rho0 = 1500;

struct artificialViscosity : testing::Test
{
    Particles P{dx};
    std::unique_ptr<EquationOfState> eos =
        make<EquationOfState>("linear; K 1e5;", rho0, 0.0);
    std::unique_ptr<Kernel> kernel = make<Kernel>("cubicSpline;", 1.3*dx);

    artificialViscosity()
    {
        Points points = squareLattice({1, 1}, 12, 12, dx);
        shake(points, 0.15*dx);
        place(P, points, rho0);
    }

    void randomVelocities(const unsigned seed)
    {
        std::mt19937_64 engine(seed);
        std::uniform_real_distribution<scalar> number(-1, 1);
        for (label i = 0; i < P.granular().end; ++i)
        {
            P.U.set(i, {number(engine), number(engine)});
            P.m[i] = rho0*dx*dx*(1 + 0.3*number(engine));
            P.V[i] = P.m[i]/P.rho[i];
        }
    }

    // Adds to what a holds
    void apply(const std::string& text)
    {
        calcGradients(P, *kernel, "kernelGradient;");
        PairWalk walk(P);
        const auto model =
            make<ArtificialViscosity>(text, *eos, *kernel);
        ASSERT_TRUE(model->hasSum());
        walkOnce(walk, *model, *kernel);
    }

    void resetAcceleration(const vector& a = vector::Zero())
    {
        for (label i = 0; i < P.granular().end; ++i)
        {
            P.a.set(i, a);
        }
    }

    // sum m a, sum m |a|, sum m a.U
    vector force() const
    {
        vector sum = vector::Zero();
        for (label i = 0; i < P.granular().end; ++i)
        {
            sum += P.m[i]*P.a[i];
        }
        return sum;
    }
    scalar forceScale() const
    {
        scalar sum = 0;
        for (label i = 0; i < P.granular().end; ++i)
        {
            sum += P.m[i]*P.a[i].norm();
        }
        return sum;
    }
    scalar power() const
    {
        scalar sum = 0;
        for (label i = 0; i < P.granular().end; ++i)
        {
            sum += P.m[i]*P.a[i].dot(P.U[i]);
        }
        return sum;
    }
};

const char* gradientCorrected = "gradientCorrected; alpha 0.3; chi 1;";
const char* Monaghan = "Monaghan; alpha 0.3;";

} // namespace

// Wherever gradients are exact for all neighbours: everywhere off the corners
TEST_F(artificialViscosity, gradientCorrectedDoesNotFeelALinearVelocity)
{
    tensor G;
    G << 0.5, 2, -1.3, -0.4;
    for (label i = 0; i < P.granular().end; ++i)
    {
        P.U.set(i, vector(2, 1) + G*P.r[i]);
    }
    apply(gradientCorrected);
    const scalar scale = 0.3*eos->c()*G.norm();
    label checked = 0;
    for (const label i : interior(P, 2.7*dx))
    {
        // U, of the size 5, cancels against its gradients
        EXPECT_LT(P.a[i].norm(), rounding(1e-10, 3e-6)*scale);
        ++checked;
    }
    EXPECT_GT(checked, 25);
}

TEST_F(artificialViscosity, conservesMomentum)
{
    for (const char* text : {gradientCorrected, Monaghan})
    {
        randomVelocities(2);
        resetAcceleration();
        apply(text);
        EXPECT_GT(forceScale(), 1);
        EXPECT_LT(force().norm(), rounding(1e-12, 5e-8)*forceScale()) << text;
    }
}

TEST_F(artificialViscosity, takesEnergyOutOfFluctuations)
{
    for (const char* text : {gradientCorrected, Monaghan})
    {
        for (unsigned seed = 1; seed <= 8; ++seed)
        {
            randomVelocities(seed);
            resetAcceleration();
            apply(text);
            EXPECT_LT(power(), -0.1*forceScale()) << text << ' ' << seed;
        }
    }
}

TEST_F(artificialViscosity, isAddedToTheAcceleration)
{
    const vector g(1, -9);
    for (const char* text : {gradientCorrected, Monaghan})
    {
        randomVelocities(3);
        resetAcceleration();
        apply(text);
        const vectorField alone = P.a;
        resetAcceleration(g);
        apply(text);
        for (label i = 0; i < P.granular().end; ++i)
        {
            EXPECT_LT((P.a[i] - alone[i] - g).norm(), 1e-12*P.a[i].norm());
        }
    }
}

// A pair with velocities along its line; gradients of U left out
TEST_F(artificialViscosity, MonaghanActsBetweenApproachingParticlesOnly)
{
    const scalar r = 0.9*dx, speed = 0.2;
    for (const scalar sign : {1.0, -1.0})
    {
        place(P, {{1, 1}, {1 + r, 1}}, rho0);
        P.U.set(0, {sign*speed, 0});
        resetAcceleration();
        apply(Monaghan);
        const scalar h = kernel->h();
        const scalar mu = h*(sign*speed)*(-r)/(r*r + 0.01*h*h);
        const scalar Pi = mu < 0 ? -0.3*eos->c()*mu/rho0 : 0;
        const scalar expected = -P.m[1]*Pi*kernel->F(r)*(-r);
        // a is 0.2 c
        const scalar little = rounding(1e-12, 5e-8)*eos->c();
        EXPECT_NEAR(P.a.x[0], expected, little);
        EXPECT_NEAR(P.a.x[1], -expected, little);
        EXPECT_EQ(P.a.x[0] < 0, sign > 0) << "slowed down";
    }
}

TEST_F(artificialViscosity, MonaghanLeavesRigidRotationAlone)
{
    for (label i = 0; i < P.granular().end; ++i)
    {
        P.U.set(i, {-P.r.y[i], P.r.x[i]});
    }
    resetAcceleration();
    apply(Monaghan);
    for (label i = 0; i < P.granular().end; ++i)
    {
        // U_ij.r cancels
        EXPECT_LT(P.a[i].norm(), rounding(1e-10, 1.5e-6)*eos->c());
    }
}

// nu = alpha c h/8: a = m 2 nu/rho0 F U_ij, without the gradients of U
TEST_F(artificialViscosity, gradientCorrectedHasTheViscosityItSays)
{
    const scalar r = 0.9*dx;
    place(P, {{1, 1}, {1 + r, 1}}, rho0);
    P.U.set(0, {0.1, 0.3});
    resetAcceleration();
    PairWalk walk(P);
    const auto model = make<ArtificialViscosity>
    (
        gradientCorrected, *eos, *kernel
    );
    walkOnce(walk, *model, *kernel);
    const scalar nu = 0.3*eos->c()*kernel->h()/8;
    const vector expected = P.m[1]*2*nu/rho0*kernel->F(r)*P.U[0];
    const scalar little = rounding(1e-12, 2e-7)*expected.norm();
    EXPECT_LT((P.a[0] - expected).norm(), little);
    EXPECT_LT((P.a[1] + expected).norm(), little);
}

// q = -chi rho0 c h div within +-p/2, 0 without pressure
TEST_F(artificialViscosity, bulkPressureResistsVolumeChangeWithinHalfOfP)
{
    const auto model = make<ArtificialViscosity>
    (
        "gradientCorrected; chi 0.7;", *eos, *kernel
    );
    const scalar factor = 0.7*rho0*eos->c()*kernel->h();
    const scalar p[] = {1e3, 1e3, 1e3, 1e3, 0, -5};
    const scalar raw[] = {200, -200, 800, -800, 300, 300};
    const scalar q[] = {200, -200, 500, -500, 0, 0};
    for (label i = 0; i < 6; ++i)
    {
        P.p[i] = p[i];
        P.div[i] = -raw[i]/factor;
    }
    model->bulkPressure(P, {0, 6});
    for (label i = 0; i < 6; ++i)
    {
        EXPECT_NEAR(P.q[i], q[i], 1e-10*std::abs(raw[i])) << i;
    }
}

TEST_F(artificialViscosity, othersHaveNoBulkPressure)
{
    for (const char* text : {"Monaghan;", "none;"})
    {
        const auto model =
            make<ArtificialViscosity>(text, *eos, *kernel);
        for (label i = 0; i < P.granular().end; ++i)
        {
            P.p[i] = 1e3;
            P.div[i] = -1;
            P.q[i] = 7;
        }
        model->bulkPressure(P, P.granular());
        for (label i = 0; i < P.granular().end; ++i)
        {
            EXPECT_EQ(P.q[i], 0);
        }
    }
    EXPECT_FALSE
    (
        make<ArtificialViscosity>("none;", *eos, *kernel)->hasSum()
    );
}

} // namespace sph
