#include "setup/createParticles.H"
#include "setup/hydrostatic.H"

#include <cmath>
#include <gtest/gtest.h>

using namespace sph;

namespace
{

const scalar rho0 = 1600;
const vector g(0, -9.81);

std::unique_ptr<EquationOfState> law(const std::string& text)
{
    return EquationOfState::New
    (
        dictionary::fromString(text), "equationOfState", rho0, g.norm()
    );
}

// Particles of a setParticlesDict at hydrostatic density
struct Column
{
    std::unique_ptr<EquationOfState> equationOfState;
    dictionary dict;
    Particles particles;
    bool rhoOfK;

    explicit Column
    (
        const std::string& text, const vector& gravity = g,
        const std::string& entries = "K 2e5;"
    )
    :
        equationOfState(law("equationOfState linear;" + entries)),
        dict(dictionary::fromString(text, "setParticlesDict"))
    {
        const Lattice lattice(dict);
        const auto regions = fillRegions(dict, lattice);
        particles.setSpacing(lattice.spacing());
        createParticles
        (
            regions, Boundaries(dictionary(), lattice.spacing()), rho0,
            particles
        );
        rhoOfK = setHydrostatic
        (
            dict, gravity, *equationOfState, regions, particles
        );
    }

    label n() const { return particles.granular().size(); }

    scalar p(const label i) const
    {
        return equationOfState->pressure(particles.rho[i]);
    }

    // K (exp(rho0 g z/K) - 1)
    static scalar exact(const scalar z, const scalar gn = 9.81)
    {
        return 2e5*std::expm1(rho0*gn*z/2e5);
    }
};

const std::string box =
    "spacing 0.05; regions ({ type box; min (0 0 0); max (1 2 0); });";

} // namespace


TEST(HydrostaticPressure, solvesTheLinearLawExactly)
{
    // From stiff to so soft that density doubles
    for (const scalar K : {1e7, 1e5, 5e4})
    {
        const auto linear = law
        (
            "equationOfState linear; K " + std::to_string(K) + ";"
        );
        const scalar exact = K*std::expm1(rho0*9.81*2.2/K);
        EXPECT_NEAR
        (
            hydrostaticPressure(*linear, 9.81, 2.2), exact, 1e-8*exact
        );
    }
}

TEST(HydrostaticPressure, solvesTaitExactly)
{
    // d(rho)/dz = rho g/c^2, c^2 = K/rho0 (rho/rho0)^(gamma - 1):
    // (rho/rho0)^(gamma - 1) = 1 + (gamma - 1) rho0 g z/K
    const scalar K = 1e5, z = 1.7, gamma = 7;
    const auto tait = law("equationOfState Tait; K 1e5; gamma 7;");
    const scalar ratio =
        std::pow(1 + (gamma - 1)*rho0*9.81*z/K, 1/(gamma - 1));
    const scalar exact = K/gamma*(std::pow(ratio, gamma) - 1);
    EXPECT_NEAR(hydrostaticPressure(*tait, 9.81, z), exact, 1e-6*exact);
}

TEST(HydrostaticPressure, isZeroAtTheSurface)
{
    EXPECT_EQ
    (
        hydrostaticPressure(*law("equationOfState linear; K 1e5;"), 9.81, 0), 0
    );
}

TEST(Hydrostatic, boxHasTheExactColumnWhateverX)
{
    const Column column(box);
    ASSERT_EQ(column.n(), 20*40);
    for (label i = 0; i < column.n(); ++i)
    {
        const scalar exact = Column::exact(2 - column.particles.r.y[i]);
        EXPECT_NEAR(column.p(i), exact, 1e-6*exact) << i;
    }
}

TEST(Hydrostatic, everyPartOfAnLHasItsOwnSurface)
{
    const Column column
    (
        "spacing 0.05; regions ({ type polygon; points"
        "((0 0 0) (2 0 0) (2 0.5 0) (1 0.5 0) (1 1.5 0) (0 1.5 0)); });"
    );
    ASSERT_EQ(column.n(), 40*10 + 20*20);
    for (label i = 0; i < column.n(); ++i)
    {
        const vector r = column.particles.r[i];
        const scalar exact = Column::exact((r.x() < 1 ? 1.5 : 0.5) - r.y());
        EXPECT_NEAR(column.p(i), exact, 1e-6*exact) << r.transpose();
    }
}

TEST(Hydrostatic, aRegionBearsTheOneOnTopOfIt)
{
    const Column column
    (
        "spacing 0.05; regions ({ type box; min (0 0 0); max (1 1 0); }"
        "{ type box; min (0.5 1 0); max (1 1.5 0); });"
    );
    for (label i = 0; i < column.n(); ++i)
    {
        const vector r = column.particles.r[i];
        const scalar exact = Column::exact((r.x() < 0.5 ? 1 : 1.5) - r.y());
        EXPECT_NEAR(column.p(i), exact, 1e-6*exact) << r.transpose();
    }
}

TEST(Hydrostatic, aBodyInTheAirDoesNotWeighOnTheBed)
{
    const Column column
    (
        "spacing 0.05; regions ({ type box; min (0 0 0); max (1 1 0); }"
        "{ type box; min (0 2 0); max (1 2.5 0); });"
    );
    for (label i = 0; i < column.n(); ++i)
    {
        const scalar y = column.particles.r.y[i];
        const scalar exact = Column::exact((y < 1 ? 1 : 2.5) - y);
        EXPECT_NEAR(column.p(i), exact, 1e-6*exact);
    }
}

TEST(Hydrostatic, depthFollowsGravity)
{
    const Column column(box, {9.81, 0});
    for (label i = 0; i < column.n(); ++i)
    {
        const scalar exact = Column::exact(column.particles.r.x[i]);
        EXPECT_NEAR(column.p(i), exact, 1e-6*exact);
    }
}

TEST(Hydrostatic, onASlopeTheNormalComponentCounts)
{
    // Tilted gravity: 3-4-5
    const Column column
    (
        box + "surfaceNormal (0 2 0);", {0.6*9.81, -0.8*9.81}
    );
    for (label i = 0; i < column.n(); ++i)
    {
        const scalar exact =
            Column::exact(2 - column.particles.r.y[i], 0.8*9.81);
        EXPECT_NEAR(column.p(i), exact, 1e-6*exact);
    }
}

TEST(Hydrostatic, canBeSwitchedOff)
{
    const Column off(box + "hydrostatic no;");
    const Column weightless(box, vector::Zero());
    EXPECT_FALSE(off.rhoOfK);
    EXPECT_FALSE(weightless.rhoOfK);
    for (label i = 0; i < off.n(); ++i)
    {
        EXPECT_EQ(off.particles.rho[i], rho0);
        EXPECT_EQ(weightless.particles.rho[i], rho0);
    }
}

TEST(Hydrostatic, aKThatFollowsBearsTheColumn)
{
    const scalar K = 100*rho0*9.81*2;
    for (const char* height : {"1e-6", "1", "2", "40"})
    {
        const Column column
        (
            box, g, std::string("adaptive yes; H ") + height + ';'
        );
        EXPECT_TRUE(column.rhoOfK);
        EXPECT_GE(column.equationOfState->K(), 0.97*K);
        EXPECT_NEAR(column.p(0), rho0*9.81*1.975, 200);
    }
    EXPECT_NEAR
    (
        Column(box, g, "adaptive yes; H 40;").equationOfState->K(), 20*K, 1
    );
    EXPECT_NEAR(Column(box, g, "H 1;").equationOfState->K(), 0.5*K, 1);
}

TEST(Hydrostatic, aSurfaceThatFacesDownIsRefused)
{
    try
    {
        Column column(box + "surfaceNormal (0 -1 0);");
        FAIL() << "no error";
    }
    catch (const IOError& error)
    {
        EXPECT_NE(error.block().find("against gravity"), std::string::npos);
        EXPECT_EQ(error.startLine(), 1);
    }
}
