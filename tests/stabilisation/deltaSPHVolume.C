#include "Stabilised.H"

namespace sph
{

using deltaSPHVolume = Stabilised;

// As deltaSPH where nothing shears
TEST_F(deltaSPHVolume, leavesWhatRestsToDeltaSPH)
{
    noise(3);
    calcGradients(P, *kernel, "kernelGradient;");
    apply("deltaSPH; delta 0.1;");
    const scalarField expected = P.rhoDot;
    apply("deltaSPHVolume; delta 0.1; beta 1;");
    scalar largest = 0;
    for (label i = 0; i < P.granular().end; ++i)
    {
        largest = std::max(largest, std::abs(expected[i]));
        EXPECT_NEAR(P.rhoDot[i], expected[i], 1e-10*std::abs(expected[i]));
    }
    EXPECT_GT(largest, 0);
}

// rho says 3 % less than the particles: it returns at beta gammaDot where the
// support is complete, and nowhere else
TEST_F(deltaSPHVolume, returnsToTheSumAtThePaceOfTheShear)
{
    setDensity([](const vector&) { return 0.97*rho0; });
    calcGradients(P, *kernel, "kernelGradient;");
    const scalar rate = 20, beta = 0.25;
    std::fill(P.gammaDot.begin(), P.gammaDot.end(), rate);
    apply("deltaSPHVolume; delta 0; beta 0.25; lambdaMin 0.95;");
    label inside = 0, outside = 0;
    for (label i = 0; i < P.granular().end; ++i)
    {
        scalar sum = 0;
        for (label j = 0; j < P.granular().end; ++j)
        {
            sum += P.m[j]*kernel->W((P.r[i] - P.r[j]).norm());
        }
        const bool complete = P.lambda[i] > 0.95;
        const scalar expected =
            complete ? beta*rate*(sum - P.rho[i]) : 0;
        EXPECT_NEAR(P.rhoDot[i], expected, 1e-9*rate*rho0);
        (complete ? inside : outside) += 1;
    }
    EXPECT_GT(inside, 10);
    EXPECT_GT(outside, 10);
}

} // namespace sph
