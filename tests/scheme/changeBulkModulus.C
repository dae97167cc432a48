#include "deposit/Energies.H"
#include "scheme/SoundSpeedColumn.H"

#include <gtest/gtest.h>

namespace sph
{

using namespace soundSpeedColumn;

namespace
{

struct changeBulkModulus : testing::TestWithParam<word>
{};

} // namespace

// p, s and positions stay; rho, V, G, c and the step follow
TEST_P(changeBulkModulus, pressureStaysWhereKChanges)
{
    for (const char* height : {"0.4", "0.02"})
    {
        Column column
        (
            std::string("adaptive yes; KFactor 100; H ") + height + ';',
            GetParam()
        );
        Particles& P = column.particles;
        column.scheme.updatePairs();
        column.scheme.extrapolateStress();
        const label apart = 33, wall = P.walls().begin + 10;
        P.rho[apart] = 0.98*rho0;
        P.s.set(50, (tensor() << 40, -30, -30, -40).finished());
        column.material.eos().correct(P.granular(), P.rho, P.p);
        ASSERT_GT(P.p[wall], 100);
        const scalarField p = P.p, rho = P.rho;
        const scalar step = column.timeStep.stable(P);

        column.follow(1.1*column.window(0.4));
        const scalar f = column.K()/column.K0;
        EXPECT_GT(std::abs(f - 1), 0.3);
        for (label i = 0; i < P.granular().end; ++i)
        {
            EXPECT_NEAR(column.pressure(i), p[i], 1e-13*column.K0);
            EXPECT_EQ(P.V[i], P.m[i]/P.rho[i]);
            EXPECT_EQ(P.Vg[i], P.V[i]);
        }
        EXPECT_EQ(P.rho[apart], 0.98*rho0);
        EXPECT_EQ(P.s.xy[50], -30);
        EXPECT_NE(P.rho[0], rho[0]);
        EXPECT_EQ(P.p[wall], p[wall]);
        EXPECT_EQ(P.rho[wall], column.material.eos().density(p[wall]));
        EXPECT_EQ(P.V[wall], P.m[wall]/P.rho[wall]);
        EXPECT_EQ(P.Vg[wall], 0);

        const Material& material = column.material;
        EXPECT_NEAR(material.rheology().G(), 0.5*material.eos().K(), 1e-9);
        EXPECT_NEAR(material.eos().c(), std::sqrt(column.K()/rho0), 1e-12);
        EXPECT_NEAR(column.timeStep.stable(P), step/std::sqrt(f), 1e-9*step);
    }
}

INSTANTIATE_TEST_SUITE_P
(
    all, changeBulkModulus, testing::Values("linear", "Tait"),
    [](const auto& info) { return info.param; }
);

TEST(changeBulkModulus, elasticEnergyChangesByLittle)
{
    Column column("adaptive yes; KFactor 100; H 0.2;");
    column.scheme.initialise();
    const Energies before(column.particles, {0, -g}, rho0);
    column.follow(1.1*column.window(0.4));
    const Energies after(column.particles, {0, -g}, rho0);
    EXPECT_EQ(after.kinetic, before.kinetic);
    EXPECT_EQ(after.potential, before.potential);
    EXPECT_NEAR
    (
        after.elastic/before.elastic, column.K0/column.K(), 0.01
    );
    EXPECT_LT(after.elastic, before.potential/300);
}

// Nothing stirs where the sound speed of a column at rest is halved
TEST(changeBulkModulus, columnStaysAtRest)
{
    Column column("adaptive yes; KFactor 100; H 0.4;", "linear", "0.2");
    column.scheme.initialise();
    column.go(0, 0.5);
    EXPECT_LT(column.KByK(H), 1.25);
    const Particles& P = column.particles;
    scalar fastest = 0, error = 0;
    for (label i = 0; i < P.granular().end; ++i)
    {
        const scalar rest = rho0*g*(H - P.r.y[i]);
        fastest = std::max(fastest, P.U[i].norm());
        error = std::max(error, std::abs(P.p[i] - rest));
    }
    EXPECT_LT(fastest, 1e-3*std::sqrt(g*H));
    EXPECT_LT(error, 0.01*rho0*g*H);
}

} // namespace sph
