// Sand at rest in a tank for 1 s: its pressure stays that of the exact column,
//
//     p = K (exp(rho0 g (H - y)/K) - 1).
//
// Prints measured values and bands.

#include "support/Scene.H"

#include <gtest/gtest.h>

#include <cstdio>

namespace sph
{

namespace
{

constexpr label n = 40;
constexpr scalar H = 0.1, dx = H/n, g = 9.81;

// Mean of p over the nearest neighbours, brought to the height of particle i
scalar smoothedPressure(const Particles& P, const label i)
{
    scalar sum = 0, count = 0;
    for (label j = 0; j < P.granular().end; ++j)
    {
        if (j != i && (P.r[j] - P.r[i]).norm() < 1.2*dx)
        {
            sum += P.p[j] + P.rho[i]*g*(P.r.y[j] - P.r.y[i]);
            ++count;
        }
    }
    return sum/count;
}

} // namespace

TEST(hydrostatic, sandInATankKeepsItsPressureForASecond)
{
    CaseText text;
    text.boundary =
        "tank { type freeSlip; points"
        " ((0 0.15 0) (0 0 0) (0.1 0 0) (0.1 0.15 0)); }";
    TestScene scene(text, dx, squareLattice({0, 0}, n, n, dx));
    scene.hydrostatic(g, H);
    scene.scheme.initialise();
    const scalar dt = scene.acousticStep();
    scene.run(dt, label(1/dt));

    const Particles& P = scene.particles;
    const scalar K = scene.material.eos().K();
    const scalar base = K*std::expm1(CaseText::rho0*g*H/K);
    scalar error = 0, roughness = 0, fastest = 0, moved = 0;
    label inside = 0;
    for (label i = 0; i < P.granular().end; ++i)
    {
        const scalar y = P.r.y[i];
        const scalar exact = K*std::expm1(CaseText::rho0*g*(H - y)/K);
        error += std::pow((P.p[i] - exact)/base, 2);
        fastest = std::max(fastest, P.U[i].norm());
        const label row = label(P.id[i])/n, column = label(P.id[i])%n;
        moved = std::max
        (
            moved, (P.r[i] - dx*vector(column + 0.5, row + 0.5)).norm()
        );
        if (y < H - 2*dx)
        {
            roughness +=
                std::pow((P.p[i] - smoothedPressure(P, i))/base, 2);
            ++inside;
        }
    }
    error = std::sqrt(error/P.granular().size());
    roughness = std::sqrt(roughness/inside);
    std::printf
    (
        "%d particles, 1 s; relative to the pressure at the base, %.1f Pa\n"
        "quantity                  measured   reference   band\n"
        "RMS error of p            %8.2e   0           0.01\n"
        "RMS roughness of p        %8.2e   0           0.005\n"
        "largest speed/sqrt(g H)   %8.2e   0           0.005\n"
        "largest displacement/dx   %8.2e   0           0.5\n",
        P.granular().size(), base, error, roughness,
        fastest/std::sqrt(g*H), moved/dx
    );
    EXPECT_LT(error, 0.01);
    EXPECT_LT(roughness, 0.005);
    EXPECT_LT(fastest, 0.005*std::sqrt(g*H));
    EXPECT_LT(moved, 0.5*dx);
    EXPECT_EQ(scene.netHits, 0);
}

} // namespace sph
