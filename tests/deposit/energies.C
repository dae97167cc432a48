#include "deposit/Energies.H"
#include "heaps.H"

#include <gtest/gtest.h>

using namespace sph;

// A column at rest under its own weight: p = rho g (H - y)
TEST(Energies, ofAColumnAreTheClosedForms)
{
    const scalar L = 0.2, H = 0.3, dx = 0.002, K = 1e6, G = 9.81;
    const scalar rho = heaps::rho0;
    Particles particles(dx);
    heaps::place(particles, heaps::column(L, H, dx));
    for (label i = 0; i < particles.granular().size(); ++i)
    {
        particles.p[i] = rho*G*(H - particles.r.y[i]);
        particles.rho[i] = rho*(1 + particles.p[i]/K);
        particles.U.set(i, {0.3, -0.4});
    }
    const Energies energies(particles, {0, -G}, rho);
    const scalar mass = rho*L*H;
    EXPECT_NEAR(energies.mass, mass, 1e-10*mass);
    EXPECT_NEAR(energies.kinetic, 0.5*mass*0.25, 1e-10*mass);
    EXPECT_NEAR(energies.potential, mass*G*H/2, 1e-10*mass);
    EXPECT_NEAR(energies.momentum.x(), 0.3*mass, 1e-10*mass);
    EXPECT_NEAR(energies.momentum.y(), -0.4*mass, 1e-10*mass);
    EXPECT_NEAR(energies.centreOfMass.x(), L/2, 1e-10);
    EXPECT_NEAR(energies.centreOfMass.y(), H/2, 1e-10);

    // integral of p^2/(2K) over the compressed volume: the midpoint rule errs
    // by (dx/H)^2/4, the volume by 3/4 of the strain at the base
    const scalar elastic = L*std::pow(rho*G, 2)*std::pow(H, 3)/(6*K);
    EXPECT_NEAR
    (
        energies.elastic, elastic*(1 - 0.75*rho*G*H/K),
        std::pow(dx/H, 2)*elastic
    );
}


TEST(Energies, areConservedByAFreeFall)
{
    const scalar G = 9.81, t = 0.13;
    Particles particles(0.01);
    heaps::place(particles, heaps::column(0.1, 0.1, 0.01));
    const Energies before(particles, {0, -G}, heaps::rho0);
    for (label i = 0; i < particles.granular().size(); ++i)
    {
        particles.r.y[i] -= 0.5*G*t*t;
        particles.U.set(i, {0, -G*t});
    }
    const Energies after(particles, {0, -G}, heaps::rho0);
    EXPECT_GT(after.kinetic, 1);
    EXPECT_NEAR(after.total(), before.total(), 1e-10*after.kinetic);
}
