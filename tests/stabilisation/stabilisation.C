#include "Stabilised.H"

namespace sph
{

using stabilisation = Stabilised;

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

TEST_F(stabilisation, noneAsksForNothing)
{
    PairWalk walk(P);
    const auto model = make<Stabilisation>("none;", *eos, *kernel);
    EXPECT_FALSE(model->hasSum());
    EXPECT_FALSE(model->needsGradRho());
    EXPECT_TRUE(walk.fields().empty());
}

TEST_F(stabilisation, refusesNegativeNumbers)
{
    EXPECT_THROW
    (
        make<Stabilisation>("deltaSPH; delta -0.1;", *eos, *kernel),
        IOError
    );
    EXPECT_THROW
    (
        make<Stabilisation>
        (
            "velocityPressureCoupling; sigma -1;", *eos, *kernel
        ),
        IOError
    );
}

} // namespace sph
