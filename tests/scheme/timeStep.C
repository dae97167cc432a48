#include "scheme/timeStep.H"

#include "support/Lattice.H"

#include <gtest/gtest.h>

namespace sph
{

namespace
{

Material material(const std::string& rheology)
{
    return Material
    (
        dictionary::fromString
        (
            "rho0 1500; equationOfState linear; linearCoeffs { K 1.5e5; }"
          + rheology
        ),
        {0, -9.81}, 0.01
    );
}

const char* fluid = "rheology Newtonian; eta 1;";
const char* sand =
    "rheology DruckerPrager; mus 0.4; d 1e-3; rhos 2500; GByK 0.5;";

struct stableTimeStep : testing::Test
{
    Particles P{0.01};
    const scalar h = 0.013, c = 10;

    stableTimeStep()
    {
        place(P, squareLattice({0, 0}, 5, 5, 0.01), 1500);
    }

    scalar stable(const std::string& solution, const std::string& rheology)
    {
        testing::internal::CaptureStdout();
        const Material m = material(rheology);
        testing::internal::GetCapturedStdout();
        return TimeStep(dictionary::fromString(solution), m, h).stable(P);
    }
};

} // namespace

TEST_F(stableTimeStep, isAcousticWithoutViscosity)
{
    EXPECT_NEAR(stable("", fluid), h/c, 1e-15);
}

// The elastic wave is faster: c_p = c sqrt(1 + G/K)
TEST_F(stableTimeStep, seesTheElasticWave)
{
    EXPECT_NEAR(stable("", sand), h/(c*std::sqrt(1.5)), 1e-15);
}

TEST_F(stableTimeStep, isViscousWhereViscosityLimits)
{
    P.eta[11] = 3000;           // nu = 2 m2/s
    EXPECT_NEAR(stable("", fluid), 0.1*h*h/2, 1e-15);
    EXPECT_NEAR(stable("viscousNumber 0.3;", fluid), 0.3*h*h/2, 1e-15);
    EXPECT_NEAR(stable("viscousLimit no;", fluid), h/c, 1e-15);
    EXPECT_NEAR
    (
        stable("viscousIntegration implicit;", fluid), h/c, 1e-15
    );
    P.eta[11] = 1e-3;
    EXPECT_NEAR(stable("", fluid), h/c, 1e-15);
}

// Its eta is a result, not a coefficient of the step
TEST_F(stableTimeStep, isNotViscousForAnElasticLaw)
{
    P.eta[11] = 1e9;
    EXPECT_NEAR(stable("", sand), h/(c*std::sqrt(1.5)), 1e-15);
}

} // namespace sph
