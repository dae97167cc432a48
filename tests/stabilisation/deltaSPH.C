#include "Stabilised.H"

namespace sph
{

using deltaSPH = Stabilised;

TEST_F(deltaSPH, leavesALinearDensityAsItIs)
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
            // rho is 150 times its difference across dx
            EXPECT_NEAR(P.rhoDot[i], 0, rounding(1e-10, 1.5e-4)*scale);
            ++checked;
        }
    }
    EXPECT_GT(checked, 100);
}

TEST_F(deltaSPH, conservesMass)
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
    EXPECT_NEAR(sum/scale, 0, rounding(1e-12, 1e-7));
}

// One particle heavier than the rest by d, gradients left out:
// rhoDot = 2 delta h c d sum V F
TEST_F(deltaSPH, spreadsALonePeak)
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
        EXPECT_NEAR
        (
            P.rhoDot[j], rate, rounding(1e-9, 1e-7)*eos->c()*d/dx
        );
        EXPECT_GE(P.rhoDot[j], 0);
        sum += VF;
    }
    const scalar rate = 2*0.15*kernel->h()*eos->c()*d*sum;
    EXPECT_LT(rate, 0);
    EXPECT_NEAR(P.rhoDot[peak]/rate, 1, rounding(1e-12, 1e-6));
}

TEST_F(deltaSPH, smoothsNoise)
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

} // namespace sph
