// Pressures of the start, and entries of the equation of state that were
// changed after setParticles.
#include "applications/AppCase.H"
#include "io/caseIO.H"

using namespace sph;

namespace
{

const std::string properties = "constant/granularProperties";
const std::string stateOfStart = "0/uniform/equationOfState";
constexpr scalar height = 0.08748, rho0gH = 1612*9.81*height;

void setEntries(const AppCase& where, const std::string& entries)
{
    where.replace
    (
        properties, "linearCoeffs[^}]*\\}", "linearCoeffs { " + entries + " }"
    );
}

scalar K(const AppCase& where, const word& time = "0")
{
    return dictionary::fromFile
    (
        where.dir()/time/"uniform"/"equationOfState"
    ).get<scalar>("K");
}

scalar greatestPressure(const AppCase& where, const word& time)
{
    Particles particles;
    readState(where.dir()/time, particles);
    const auto p = particles.p.begin();
    return *std::max_element(p, p + particles.granular().end);
}

} // namespace

TEST(startPressures, ofAHydrostaticStartBelongToItsK)
{
    const AppCase where;
    where.write(stateOfStart, "K 1;");
    where.write("0/uniform/time", "");
    where.succeed("setParticles");
    EXPECT_FALSE(where.has("0/uniform/time"));
    EXPECT_NEAR(K(where), 100*rho0gH, 1);

    where.append("system/setParticlesDict", "hydrostatic no;");
    where.succeed("setParticles");
    EXPECT_FALSE(where.has("0/uniform"));
}

// Pressures that are rounding, as those of 2500 kg/m3 and K = 365 kPa are
TEST(startPressures, ofAStartWithoutThemMayBeRounding)
{
    const AppCase where;
    where.append("system/setParticlesDict", "hydrostatic no;");
    where.append
    (
        "constant/granularProperties", "rho0 2500; linearCoeffs { H 0.149; }"
    );
    where.succeed("setParticles");
    where.succeed("granularFoamSPH -dry-run");
}

TEST(startPressures, ofALithostaticStartHaveTheirShareSidewards)
{
    const AppCase where;
    where.append("system/setParticlesDict", "stress lithostatic; K0 0.5;");
    where.succeed("setParticles");
    Particles particles;
    readState(where.dir()/"0", particles);
    const scalar least = 1e-9*rho0gH;
    for (label i = 0; i < particles.granular().end; ++i)
    {
        EXPECT_NEAR(particles.s.yy[i], -particles.p[i]/3, least);
        EXPECT_NEAR(particles.s.xx[i], particles.p[i]/3, least);
    }
    // p = 3/4 of the weight above
    EXPECT_NEAR
    (
        *std::max_element(particles.p.begin(), particles.p.end()),
        0.75*0.95*rho0gH, 0.01*rho0gH
    );
}

TEST(startPressures, stayWhereKIsChangedAfterwards)
{
    for (const char* entries : {"KFactor 500; H 0.08748;", "K 3e6;"})
    {
        const AppCase where;
        where.succeed("setParticles");
        setEntries(where, entries);
        where.set("system/controlDict", "endTime", "2e-4");
        where.set("system/controlDict", "writeInterval", "1e-4");
        EXPECT_TRUE(says(where.succeed("granularFoamSPH"), "Sound speed 9.2"));
        EXPECT_NEAR(greatestPressure(where, "0.0001"), rho0gH, 0.1*rho0gH);
    }
}

TEST(startPressures, areThoseOfTheColumnHoweverLowTheGuess)
{
    const AppCase where;
    setEntries(where, "KFactor 100; H 1e-6; adaptive yes;");
    where.succeed("setParticles");
    EXPECT_NEAR(greatestPressure(where, "0"), rho0gH, 0.06*rho0gH);
}

TEST(startPressures, ofAnotherLawAreRefused)
{
    const AppCase where;
    where.succeed("setParticles");
    where.replace(properties, "linear;", "Tait;");
    where.replace(properties, "linearCoeffs", "TaitCoeffs");
    const Outcome outcome = where.run("granularFoamSPH");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_TRUE(says(outcome, "Run setParticles again"));
}

// A failed start leaves the particles as they were
TEST(startPressures, stayWhereAFailedStartIsMended)
{
    const AppCase where;
    where.succeed("setParticles");
    setEntries(where, "KFactor 100; H 1e-6; adaptive yes;");
    const Outcome low = where.run("granularFoamSPH");
    EXPECT_EQ(low.code, 1);
    EXPECT_TRUE(says(low, "Give a greater H"));

    setEntries(where, "KFactor 10; H 0.002; adaptive yes;");
    const std::string domain = "domain { min (-1 -1 0); max (0.09235 1 0); }";
    where.append("system/sphSolution", domain);
    const Outcome wild = where.run("granularFoamSPH");
    EXPECT_EQ(wild.code, 1);
    EXPECT_TRUE(says(wild, "What to try"));
    EXPECT_TRUE(says(wild, "H: K follows up to 100 times that of H"));
    EXPECT_FALSE(contains(wild.text, "or adaptive yes"));
    EXPECT_NEAR(K(where), 100*rho0gH, 1);

    setEntries(where, "KFactor 100; H 0.08748; adaptive yes;");
    where.replace("system/sphSolution", "domain .*", "");
    where.set("system/controlDict", "writeInterval", "1e-4");
    where.set("system/controlDict", "endTime", "1e-4");
    where.succeed("granularFoamSPH");
    EXPECT_NEAR(K(where, "0.0001"), 100*rho0gH, 1);
    EXPECT_NEAR(greatestPressure(where, "0.0001"), rho0gH, 0.1*rho0gH);
}
