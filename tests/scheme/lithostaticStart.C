// Layers that start with the stress that they have at rest do not ring.
#include "setup/lithostatic.H"
#include "support/Scene.H"

#include <gtest/gtest.h>

#include <cstdio>

namespace sph
{

namespace
{

constexpr label n = 20;
constexpr scalar dx = 0.005, H = n*dx, g = 9.81;

struct Start
{
    scalar fastest;         // within 0.2 s [sqrt(g H)]
    scalar kinetic;         // greatest kinetic energy [m g H]
    scalar normal;          // RMS errors at the end of the stress normal to the
    scalar along;           // layer and along it [rho0 g H]
};

// rho as the setup gives it; s if the stress is asked for
Start run
(
    CaseText text, const label nx, const scalar K0, const std::string& entries
)
{
    TestScene scene(text, dx, squareLattice({0, 0}, nx, n, dx));
    Particles& P = scene.particles;
    const EquationOfState& eos = scene.material.eos();
    const scalar share = (1 + K0)/2, gn = -text.g.y();
    scene.hydrostatic(gn*share, H);
    setLithostatic
    (
        dictionary::fromString(entries + "surfaceNormal (0 1 0);", "setup"),
        text.g, dictionary::fromString(text.properties(), "properties"), eos, P
    );
    scene.scheme.initialise();

    Start start{0, 0, 0, 0};
    const scalar dt = scene.acousticStep();
    const label N = P.granular().end;
    for (label step = 0; step < label(0.2/dt); ++step)
    {
        scene.step(dt);
        start.kinetic = std::max(start.kinetic, scene.kineticEnergy());
        for (label i = 0; i < N; ++i)
        {
            start.fastest = std::max(start.fastest, P.U[i].norm());
        }
    }
    for (label i = 0; i < N; ++i)
    {
        const scalar z = H - P.r.y[i];
        const scalar S =
            eos.K()/share*std::expm1(CaseText::rho0*gn*share*z/eos.K());
        start.normal += std::pow(P.p[i] - P.s.yy[i] - S, 2)/N;
        start.along += std::pow(P.p[i] - P.s.xx[i] - K0*S, 2)/N;
    }
    const scalar pressure = CaseText::rho0*g*H;
    start.fastest /= std::sqrt(g*H);
    start.kinetic /= pressure*nx*dx*H;
    start.normal = std::sqrt(start.normal)/pressure;
    start.along = std::sqrt(start.along)/pressure;
    std::printf
    (
        "fastest %.2e sqrt(g H), kinetic energy %.2e m g H, error of the stress"
        " normal %.4f and along %.4f rho g H\n",
        start.fastest, start.kinetic, start.normal, start.along
    );
    return start;
}

} // namespace

// Between smooth sides that hold K0 of the weight, and along which the surface
// rows slip down as they settle
TEST(lithostaticStart, aColumnStaysAtRestWithItsK0)
{
    CaseText text;
    text.boundary =
        "bed { type noSlip; points ((-0.015 0 0) (0.065 0 0)); }"
        "left { type freeSlip; points ((0 0.15 0) (0 0 0)); }"
        "right { type freeSlip; points ((0.05 0 0) (0.05 0.15 0)); }";
    for (const scalar K0 : {0.5, 1.5})
    {
        const Start start = run
        (
            text, 10, K0, "stress lithostatic; K0 " + std::to_string(K0) + ';'
        );
        EXPECT_LT(start.fastest, 0.0025);
        EXPECT_LT(start.kinetic, 1e-6);
        EXPECT_LT(start.normal, 0.01);
        EXPECT_LT(start.along, 0.02);
    }
}

// On a slope below yield, against the same layer with its pressure alone
TEST(lithostaticStart, aLayerOnASlopeStaysAtRest)
{
    CaseText text;
    text.g = g*vector(std::sin(20*pi/180), -std::cos(20*pi/180));
    text.boundary =
        "ends { type periodic; point (0 0 0); translation (0.04 0 0); }"
        "bed { type noSlip; points ((0 0 0) (0.04 0 0)); }";
    const Start with = run(text, 8, 1, "stress lithostatic;");
    const Start without = run(text, 8, 1, "");
    EXPECT_LT(with.fastest, 0.1*without.fastest);
    EXPECT_LT(with.kinetic, 1e-3*without.kinetic);
    EXPECT_LT(with.normal, 0.01);
    EXPECT_LT(with.along, 0.01);
}

} // namespace sph
