#include "support/Lattice.H"
#include "support/Pairs.H"
#include "turbulence/Turbulence.H"

#include <gtest/gtest.h>

namespace sph
{

// dx = 0.001, Cs = 0.2, simple shear of 50 1/s: nut = 4e-8 50 = 2e-6 m2/s,
// k = (2e-6/8e-5)^2 = 6.25e-4 m2/s2
TEST(turbulence, SmagorinskyByHand)
{
    Particles P(0.001);
    place(P, {{0, 0}, {1, 0}}, 1500);
    for (label i = 0; i < 2; ++i)
    {
        P.gradU.set(i, (tensor() << 0, 50, 0, 0).finished());
        P.gammaDot[i] = 50;
        P.T.set(i, (tensor() << -3, 1, 1, -5).finished());
    }
    make<Turbulence>("Smagorinsky;", 0.001)->addStress(P, {0, 1});

    const scalar rho = 1500, nut = 2e-6, k = 6.25e-4;
    EXPECT_NEAR(P.T.xy[0], 1 + nut*50/rho, 1e-18);
    EXPECT_NEAR(P.T.xx[0], -3 - 2*k/3/rho, 1e-15);
    EXPECT_NEAR(P.T.yy[0], -5 - 2*k/3/rho, 1e-15);
    // outside the range
    EXPECT_EQ(P.T.xy[1], 1);
}

TEST(turbulence, SmagorinskyOfExtension)
{
    Particles P(0.001);
    place(P, {{0, 0}}, 1000);
    P.gradU.set(0, (tensor() << 30, 0, 0, -30).finished());
    P.gammaDot[0] = 60;
    make<Turbulence>("Smagorinsky; Cs 0.1;", 0.001)->addStress(P, {0, 1});
    const scalar nut = 1e-8*60, k = std::pow(nut/8e-5, 2);
    EXPECT_NEAR(P.T.xx[0], (60*nut - 2*k/3)/1000, 1e-18);
    EXPECT_NEAR(P.T.yy[0], (-60*nut - 2*k/3)/1000, 1e-18);
    EXPECT_EQ(P.T.xy[0], 0);
}

TEST(turbulence, laminarAddsNothing)
{
    Particles P(0.001);
    place(P, {{0, 0}}, 1000);
    P.gradU.set(0, (tensor() << 30, 1, 0, -30).finished());
    P.gammaDot[0] = 60;
    make<Turbulence>("laminar;", 0.001)->addStress(P, {0, 1});
    EXPECT_EQ(P.T[0], tensor::Zero());
}

} // namespace sph
