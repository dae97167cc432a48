// The function objects probes and sets: fields at points and along lines.
#include "TestRun.H"

#include "io/caseIO.H"

using namespace sph;

namespace
{

// A column of 0.1 m, 20 rows, with p and U linear
struct Linear : TestRun
{
    Linear()
    {
        for (label i = 0; i < particles.granular().end; ++i)
        {
            const vector r = particles.r[i];
            particles.p[i] = 1500*9.81*(0.1 - r.y());
            particles.U.set(i, {2*r.y(), -3*r.x()});
        }
    }

    std::string error(const std::string& functions)
    {
        return errorOf([&]{ go(functions, 0.01); });
    }
};

} // namespace


TEST(probes, writeARowOfEveryFieldEachTime)
{
    Linear run;
    run.go
    (
        "here { type probes; fields (p U);"
        " probeLocations ((0.05 0.02 0) (0.031 0.1 0) (0.05 0.2 0)); }",
        0.02,
        [&](const scalar time) { run.particles.p[0] = time; }
    );
    const wordList columns{"Time", "U.x_0", "U.y_0", "U.x_1", "U.y_1", "U.x_2"};
    wordList read = run.columns("here/0/U.dat");
    ASSERT_EQ(read.size(), 7u);
    read.pop_back();
    EXPECT_EQ(read, columns);

    const auto p = run.rows("here/0/p.dat"), U = run.rows("here/0/U.dat");
    ASSERT_EQ(p.size(), 3u);
    ASSERT_EQ(U.size(), 3u);
    EXPECT_NEAR(p[2][0], 0.02, 1e-9);
    EXPECT_NEAR(p[0][1], 1500*9.81*0.08, 1e-5);
    EXPECT_NEAR(p[0][2], 0, 1e-5);
    EXPECT_NEAR(U[0][1], 0.04, 1e-9);
    EXPECT_NEAR(U[0][2], -0.15, 1e-9);
    EXPECT_NEAR(U[0][3], 0.2, 1e-9);
    EXPECT_CONTAINS
    (
        run.dir.text("postProcessing/here/0/p.dat"),
        "# Probe 1 (0.031 0.1 0)"
    );
    EXPECT_CONTAINS(run.dir.text("postProcessing/here/0/p.dat"), "nan");
}


TEST(probes, restartMakesAFolderOfItsOwn)
{
    const std::string functions =
        "here { type probes; fields (p); probeLocations ((0.05 0.02 0)); }";
    Linear run;
    run.go(functions, 0.01);
    run.go(functions, 0.01);
    writeState(run.particles, 0.01, run.dir.dir()/"0.01", {});
    run.go(functions, 0.03);
    EXPECT_EQ(run.rows("here/0/p.dat").size(), 2u);
    EXPECT_EQ(run.rows("here/0_1/p.dat").size(), 2u);
    EXPECT_EQ(run.rows("here/0.01/p.dat").size(), 3u);
}


TEST(probes, refuseWhatTheyCannotLookAt)
{
    Linear run;
    EXPECT_CONTAINS
    (
        run.error("a { type probes; fields (p); probeLocations (); }"),
        "must be a point"
    );
    EXPECT_CONTAINS
    (
        run.error
        (
            "a { type probes; fields (pressure);"
            " probeLocations ((0 0 0)); }"
        ),
        "Unknown field pressure"
    );
    EXPECT_CONTAINS
    (
        run.error("a { type probes; fields (p); points ((0 0 0)); }"),
        "probeLocations"
    );
}


TEST(sets, writeAFileOfEachLineAtWriteTimes)
{
    Linear run;
    run.go
    (
        "lines { type sets; fields (p U); sets {"
        " up { start (0.05 0 0); end (0.05 0.12 0); nPoints 7; }"
        " slanted { type uniform; start (0.01 0.01 0); end (0.04 0.05 0);"
        " nPoints 2; } } }",
        0.08
    );
    const wordList columns{"distance", "x", "y", "p", "U.x", "U.y"};
    EXPECT_EQ(run.columns("lines/0/up_0.dat"), columns);
    const auto up = run.rows("lines/0/up_0.05.dat");
    ASSERT_EQ(up.size(), 7u);
    for (label k = 0; k < 6; ++k)
    {
        const scalar y = 0.02*k;
        ASSERT_EQ(up[k].size(), 6u);
        EXPECT_NEAR(up[k][0], y, 1e-9);
        EXPECT_NEAR(up[k][1], 0.05, 1e-9);
        EXPECT_NEAR(up[k][2], y, 1e-9);
        EXPECT_NEAR(up[k][3], 1500*9.81*(0.1 - y), 1e-5);
        EXPECT_NEAR(up[k][4], 2*y, 1e-9);
        EXPECT_NEAR(up[k][5], -0.15, 1e-9);
    }
    EXPECT_NEAR(run.rows("lines/0/slanted_0.dat")[1][0], 0.05, 1e-9);

    // the start, the write time and the end, no other step
    EXPECT_FALSE(run.dir.has("postProcessing/lines/0/up_0.01.dat"));
    EXPECT_TRUE(run.dir.has("postProcessing/lines/0/up_0.08.dat"));
}


TEST(sets, refuseLinesThatAreNone)
{
    const auto error = [](const std::string& line)
    {
        return Linear().error
        (
            "a { type sets; fields (p); sets { b { " + line + " } } }"
        );
    };
    EXPECT_CONTAINS
    (
        error("start (0 0 0); end (0 1 0); nPoints 1;"), "must be at least 2"
    );
    EXPECT_CONTAINS
    (
        error("start (0 1 0); end (0 1 0); nPoints 5;"), "begins where"
    );
    EXPECT_CONTAINS
    (
        error("type cloud; start (0 0 0); end (0 1 0); nPoints 5;"), "uniform"
    );
    EXPECT_CONTAINS
    (
        error("start (0 0 0); end (0 1 0); nPoints 5; npoints 6;"), "npoints"
    );
    EXPECT_CONTAINS
    (
        Linear().error("a { type sets; fields (p); sets {} }"),
        "must be a line"
    );
}
