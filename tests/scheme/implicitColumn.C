#include "scheme/timeStep.H"
#include "support/Scene.H"

#include <gtest/gtest.h>

#include <regex>

namespace sph
{

// Where the viscosity is that of sand at rest, and where the solver fails
namespace
{

// A column of sand, rows of 10 on a rough bed, with the paper's viscosity
struct SandColumn
{
    CaseText text;
    std::unique_ptr<TestScene> scene;

    explicit SandColumn(const std::string& solver = "")
    {
        text.rheology =
            "rheology muI; mus 0.589; mu2 1.248; I0 0.279; d 3.2e-4;"
            "rhos 2600; regularisation Papanastasiou; alphar 0.01;";
        text.equationOfState =
            "equationOfState linear; linearCoeffs { KFactor 50; H 0.1; }";
        text.viscousScheme = "viscousScheme Cleary;";
        text.solution += "viscousIntegration implicit;" + solver;
        text.boundary =
            "bed { type noSlip; points ((-0.1 0 0) (0.5 0 0)); }"
            "axis { type symmetryPlane; point (0 0 0); normal (1 0 0); }";
        scene = std::make_unique<TestScene>
        (
            text, 0.01, squareLattice({0, 0}, 10, 10, 0.01)
        );
        scene->hydrostatic(9.81, 0.1);
        scene->scheme.initialise();
    }
};

} // namespace

// In acoustic steps, thousands of times those of the viscous limit (33)
TEST(implicitColumn, ofSandWithThePapersViscosity)
{
    SandColumn column("viscousSolver { tolerance 1e-6; maxIter 500; }");
    TestScene& scene = *column.scene;
    Particles& P = scene.particles;
    const scalar dt = scene.acousticStep(0.2);
    const scalar h = scene.scheme.kernel().h();
    label mostIterations = 0;
    scalar etaMax = 0, UMax = 0;
    for (label step = 0; step < 600; ++step)
    {
        scene.step(dt);
        const ImplicitViscosity& solver = *scene.scheme.implicitViscosity();
        mostIterations = std::max(mostIterations, solver.iterations());
        EXPECT_LT(solver.finalResidual(), 1e-6);
        for (label i = 0; i < P.granular().end; ++i)
        {
            etaMax = std::max(etaMax, P.eta[i]);
            UMax = std::max(UMax, P.U[i].norm());
        }
    }
    const scalar viscousStep = 0.02*CaseText::rho0*h*h/etaMax;
    EXPECT_GT(dt, 1e3*viscousStep);
    EXPECT_LT(mostIterations, 100);
    // It has begun to fall, and no faster than freely
    EXPECT_LT(UMax, std::sqrt(2*9.81*0.1));
    EXPECT_GT(UMax, 0.05);
}

TEST(implicitColumn, printsAsOpenFOAMsSolversDo)
{
    SandColumn column;
    std::ostringstream log;
    std::streambuf* quiet = std::cout.rdbuf(log.rdbuf());
    column.scene->step(column.scene->acousticStep(0.2));
    std::cout.rdbuf(quiet);
    const std::regex line
    (
        "PCG:  Solving for U, Initial residual = [0-9.e+-]+, "
        "Final residual = [0-9.e+-]+, No Iterations [0-9]+\n"
    );
    EXPECT_TRUE(std::regex_match(log.str(), line)) << log.str();
}

TEST(implicitColumn, saysOnceThatItHasNotConverged)
{
    SandColumn column("viscousSolver { tolerance 1e-12; maxIter 2; }");
    TestScene& scene = *column.scene;
    testing::internal::CaptureStderr();
    for (label step = 0; step < 20; ++step)
    {
        scene.step(scene.acousticStep(0.2));
        EXPECT_EQ(scene.scheme.implicitViscosity()->iterations(), 2);
    }
    const std::string said = testing::internal::GetCapturedStderr();
    const auto first = said.find("has not converged in maxIter 2");
    EXPECT_NE(first, std::string::npos) << said;
    EXPECT_EQ(said.find("has not converged", first + 1), std::string::npos);
}

TEST(implicitColumn, stopsAtANumberThatIsNotFinite)
{
    SandColumn column;
    column.scene->particles.U.x[33] = std::nan("");
    EXPECT_THROW(column.scene->scheme.forces(1e-4), Error);
}

TEST(implicitColumn, refusesWhatItCannotSolve)
{
    const auto scene = [](const char* scheme, const std::string& solution)
    {
        CaseText text = CaseText::plain();
        text.viscousScheme = std::string("viscousScheme ") + scheme + ';';
        text.solution += "viscousIntegration implicit;" + solution;
        TestScene(text, 0.01);
    };
    for
    (
        const char* scheme :
        {"stressDivergence", "SchwaigerMorris", "SchwaigerAsPrinted"}
    )
    {
        try
        {
            scene(scheme, "");
            ADD_FAILURE() << scheme;
        }
        catch (const IOError& error)
        {
            EXPECT_NE
            (
                std::string(error.what()).find("Morris or Cleary"),
                std::string::npos
            );
        }
    }
    EXPECT_THROW(scene("Morris", "sleep {}"), IOError);
    for (const char* entry : {"tolerance 0;", "relTol 2;", "maxIter 0;"})
    {
        EXPECT_THROW
        (
            scene("Morris", std::string("viscousSolver {") + entry + '}'),
            IOError
        ) << entry;
    }
    EXPECT_NO_THROW(scene("Morris", "viscousSolver { relTol 0.1; }"));
}

} // namespace sph
