// Flows whose steady state follows from the friction of side walls.

#include "support/Scene.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

namespace sph
{

namespace
{

constexpr label nx = 8;

std::string ends(const scalar dx)
{
    return "ends { type periodic; point (0 0 0); translation ("
      + std::to_string(nx*dx) + " 0 0); }";
}

std::string bed(const std::string& type, const scalar dx)
{
    return "bed { type " + type + "; points ((0 0 0) ("
      + std::to_string(nx*dx) + " 0 0));";
}

std::string coulomb(const scalar W, const scalar muWall)
{
    return "sideWalls Coulomb; CoulombCoeffs { W " + std::to_string(W)
      + "; muWall " + std::to_string(muWall) + "; }";
}

} // namespace

// A silo whose bottom goes down slowly, so that the walls bear all they can.
// A fluid's pressure on the side walls is that on the bed:
//
//     dp/dz = rho g - 2 muWall p/W:   p = rho g l (1 - exp(-z/l)),
//                                     l = W/(2 muWall)
//
// Janssen, Z. Ver. Dtsch. Ing. 39, 1045 (1895), with K = 1.
TEST(sideWalls, JanssenSilo)
{
    const label ny = 40;
    constexpr scalar H = 0.2, dx = H/ny, g = 9.81, l = 0.05, speed = 0.02;
    CaseText text;
    text.rheology =
        coulomb(0.03, 0.3) + "rheology Newtonian; NewtonianCoeffs { eta 0; }";
    text.boundary = ends(dx) + bed("freeSlip", dx)
      + "motion { velocity (0 -0.02 0); end 10; } }";
    TestScene scene(text, dx, squareLattice({0, 0}, nx, ny, dx));
    scene.scheme.wallForces().watch();
    scene.scheme.initialise();
    const scalar dt = scene.acousticStep();
    scene.run(dt, label(0.5/dt));

    // Mean over 0.1 s
    const scalar most = CaseText::rho0*g*l;
    const auto exact = [&](const scalar z) { return most*(1 - std::exp(-z/l)); };
    const Particles& P = scene.particles;
    const label patch = scene.scheme.wallForces().walls().at("bed");
    const label steps = label(0.1/dt);
    scalar onBed = 0, error = 0, fastest = 0;
    for (label k = 0; k < steps; ++k)
    {
        scene.step(dt);
        const vector F =
            scene.scheme.wallForces().on({patch}, vector::Zero()).total();
        onBed += -F.y()/(nx*dx)/steps;
        const auto highest =
            std::max_element(P.r.y.begin(), P.r.y.begin() + P.granular().end);
        const scalar surface = *highest + 0.5*dx;
        for (label i = 0; i < P.granular().end; ++i)
        {
            const scalar e = P.p[i] - exact(surface - P.r.y[i]);
            error += e*e/steps/P.granular().size();
            fastest = std::max(fastest, std::abs(P.U.y[i] + speed));
        }
    }
    std::printf
    (
        "pressure at the bed %.4f of rho g l, Janssen %.4f, without walls"
        " %.2f; RMS error of p %.4f; greatest |U_y + %g| %.4f m/s\n",
        onBed/most, exact(H)/most, H/l, std::sqrt(error)/most, speed, fastest
    );
    EXPECT_NEAR(onBed, exact(H), 0.03*most);
    EXPECT_LT(std::sqrt(error), 0.015*most);
}

// Flow down a pile between side walls: the friction that the layer needs
// decreases with depth,
//
//     mu(I) = tan theta - muWall z/W
//
// so that it flows above h = W (tan theta - mus)/muWall and stands below.
// Jop, Forterre & Pouliquen, J. Fluid Mech. 541, 167 (2005).
TEST(sideWalls, surfaceFlowOnAPile)
{
    const label ny = 20;
    const scalar H = 0.06, dx = H/ny, tanTheta = 0.58, h = 0.03;
    const scalar mus = 0.38, mu2 = 0.64, I0 = 0.279, d = 0.01, rhos = 2600;
    const scalar muWall = 0.3, W = muWall*h/(tanTheta - mus);
    const scalar theta = std::atan(tanTheta);
    CaseText text;
    text.g = 9.81*vector(std::sin(theta), -std::cos(theta));
    text.rheology = coulomb(W, muWall)
      + "rheology elastoViscoplasticMuI; elastoViscoplasticMuICoeffs"
        "{ mus 0.38; mu2 0.64; I0 0.279; d 0.01; rhos 2600; }";
    text.boundary = ends(dx) + bed("noSlip", dx) + '}';
    TestScene scene(text, dx, squareLattice({0, 0}, nx, ny, dx));
    scene.hydrostatic(-text.g.y(), H);
    scene.scheme.initialise();
    const scalar dt = scene.acousticStep();
    scene.run(dt, label(1.5/dt));

    const auto rate = [&](const scalar z)
    {
        const scalar mu = tanTheta - muWall*z/W;
        const scalar I = mu > mus ? I0*(mu - mus)/(mu2 - mu) : 0;
        return I*std::sqrt(-CaseText::rho0*text.g.y()*z/rhos)/d;
    };
    const auto exact = [&](const scalar z)
    {
        const label n = 200;
        scalar U = 0;
        for (label k = 0; k < n; ++k)
        {
            U += std::max(h - z, 0.0)/n*rate(z + (k + 0.5)*(h - z)/n);
        }
        return U;
    };

    const Particles& P = scene.particles;
    scalar error = 0, below = 0;
    scalar top = 0;
    for (label i = 0; i < P.granular().end; ++i)
    {
        const scalar z = H - P.r.y[i];
        error += std::pow(P.U.x[i] - exact(z), 2)/P.granular().size();
        below = std::max(below, z > h + 2*dx ? P.U[i].norm() : 0);
        top = std::max(top, P.U.x[i]);
    }
    const scalar surface = exact(0);
    std::printf
    (
        "velocity at the surface %.4f m/s, exact %.4f; RMS error %.4f of it;"
        " fastest below the layer %.2e of it\n",
        top, surface, std::sqrt(error)/surface, below/surface
    );
    EXPECT_LT(std::sqrt(error), 0.03*surface);
    EXPECT_NEAR(top, surface, 0.05*surface);
    EXPECT_LT(below, 1e-6*surface);
}

} // namespace sph
