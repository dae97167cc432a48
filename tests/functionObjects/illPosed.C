#include "TestRun.H"

#include "io/caseIO.H"
#include "rheology/Rheology.H"
#include "support/Pairs.H"

using namespace sph;

namespace
{

struct Marked : TestRun
{
    std::unique_ptr<EquationOfState> eos =
        make<EquationOfState>("linear; K 1e5;", 1500.0, 0.0);
    std::unique_ptr<Rheology> rheology;

    void execute(const std::string& law)
    {
        rheology = make<Rheology>(law, *eos);
        FunctionObjects objects
        ({
            dir.dir(), "0", g, heaps::rho0, particles, nullptr, nullptr,
            rheology.get()
        });
        const dictionary dict = dictionary::fromString("type illPosed;");
        objects.add("illPosed", dict);
        dict.refuseUnused();
        objects.execute(0);
    }
};

// Well posed for 0.01935 < I < 0.85227
const std::string glass =
    "elastoViscoplasticMuI; mus 0.38186; mu2 0.64347; I0 0.279; d 5e-4;"
    " rhos 2500;";

} // namespace

TEST(illPosed, marksParticlesOutsideTheKnownBounds)
{
    Marked run;
    Particles& P = run.particles;
    const scalar I[] = {0, 1e-6, 0.0193, 0.0194, 0.3, 0.852, 0.853, 5};
    const bool marked[] =
        {false, true, true, false, false, false, true, true};
    for (label i = 0; i < P.granular().end; ++i)
    {
        P.I[i] = I[i%8];
    }
    run.execute(glass);
    for (label i = 0; i < P.granular().end; ++i)
    {
        EXPECT_EQ(P.illPosed[i] > 0, marked[i%8]) << I[i%8];
    }
    EXPECT_EQ(P.illPosed[0], 0) << "at rest nothing flows";

    const wordList columns{"Time", "flowing", "illPosed"};
    EXPECT_EQ(run.columns("illPosed/0/illPosed.dat"), columns);
    const auto rows = run.rows("illPosed/0/illPosed.dat");
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_NEAR(rows[0][1], 7.0/8, 1e-9);
    EXPECT_NEAR(rows[0][2], 4.0/8, 1e-9);
}

TEST(illPosed, isWrittenWithTheParticles)
{
    Marked run;
    run.particles.I[3] = 5;
    writeState(run.particles, 0, run.dir.dir()/"0", {});
    EXPECT_EQ(run.dir.text("0/granular.vtp").find("illPosed"), std::string::npos);
    run.execute(glass);
    writeState(run.particles, 0, run.dir.dir()/"0", {});
    EXPECT_NE(run.dir.text("0/granular.vtp").find("illPosed"), std::string::npos);
}

TEST(illPosed, needsALawOfFriction)
{
    Marked run;
    EXPECT_THROW(run.execute("Newtonian; eta 1;"), IOError);
}
