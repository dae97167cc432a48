#include "TestRun.H"

#include "io/caseIO.H"

using namespace sph;

TEST(runout, writesNamedColumns)
{
    TestRun run;
    run.go
    (
        "front { type runout; L0 0.1; H0 0.1; profileInterval 1; }", 0.02,
        [&](const scalar time)
        {
            const scalar L = 0.1 + 5*time;
            heaps::place
            (
                run.particles, heaps::triangle(L, 0.02/L, 0.005)
            );
        }
    );
    const wordList columns
    {
        "Time", "t/tc", "frontLeft", "frontRight", "runout", "height",
        "heightAtOrigin", "mobilised"
    };
    EXPECT_EQ(run.columns("front/0/front.dat"), columns);

    const auto rows = run.rows("front/0/front.dat");
    ASSERT_EQ(rows.size(), 3u);
    const auto& last = rows.back();
    ASSERT_EQ(last.size(), columns.size());
    EXPECT_NEAR(last[0], 0.02, 1e-9);
    EXPECT_NEAR(last[1], 0.02/std::sqrt(0.1/9.81), 1e-6);
    EXPECT_NEAR(last[3], 0.195, 0.005);     // half a particle thick
    EXPECT_NEAR(last[4], last[3]/0.1 - 1, 1e-6);
    EXPECT_NEAR(last[5], 0.1, 0.006);

    scalar volume = 0;
    for (const auto& row : run.rows("front/0/profile_0.02.dat"))
    {
        volume += row[1]*0.01;
    }
    EXPECT_NEAR(volume, run.particles.granular().size()*0.005*0.005, 1e-8);
}


TEST(energies, countFromTheFirstTimeOfTheCase)
{
    TestRun run;
    const scalar mass = heaps::rho0*0.1*0.1;
    const auto fall = [&](const scalar depth)
    {
        for (label i = 0; i < run.particles.granular().size(); ++i)
        {
            run.particles.r.y[i] -= depth;
        }
    };
    writeState(run.particles, 0, run.dir.dir()/"0", {});
    run.go("e { type energies; }", 0.01, [&](scalar) { fall(0.02); });
    const auto first = run.rows("e/0/e.dat");
    EXPECT_NEAR(first[0][2], 0, 1e-9);
    EXPECT_NEAR(first[1][2], -mass*9.81*0.02, 1e-6);
    EXPECT_NEAR(first[1][4], mass*9.81*0.02, 1e-6);
    EXPECT_EQ(run.columns("e/0/e.dat").size(), first[0].size());

    // a restart goes on counting
    writeState(run.particles, 0.01, run.dir.dir()/"0.01", {});
    run.go("e { type energies; }", 0.02, [&](scalar) { fall(0.01); });
    const auto second = run.rows("e/0.01/e.dat");
    EXPECT_NEAR(second[0][2], -mass*9.81*0.02, 1e-6);
    EXPECT_NEAR(second[1][2], -mass*9.81*0.03, 1e-6);
}


TEST(fieldMinMax, findsExtremesAndTheirPlaces)
{
    TestRun run;
    run.particles.U.set(7, {3, -4});
    run.particles.p[3] = -2;
    run.go("m { type fieldMinMax; fields (U p); }", 0.01);
    const wordList columns
    {
        "Time",
        "min(|U|)", "min(|U|).x", "min(|U|).y",
        "max(|U|)", "max(|U|).x", "max(|U|).y",
        "min(p)", "min(p).x", "min(p).y", "max(p)", "max(p).x", "max(p).y"
    };
    EXPECT_EQ(run.columns("m/0/m.dat"), columns);
    const auto row = run.rows("m/0/m.dat").back();
    ASSERT_EQ(row.size(), columns.size());
    EXPECT_DOUBLE_EQ(row[1], 0);
    EXPECT_DOUBLE_EQ(row[4], 5);
    EXPECT_NEAR(row[5], run.particles.r.x[7], 1e-8);
    EXPECT_NEAR(row[6], run.particles.r.y[7], 1e-8);
    EXPECT_DOUBLE_EQ(row[7], -2);
    EXPECT_NEAR(row[9], run.particles.r.y[3], 1e-8);
}


TEST(image, keepsScriptAndDataOfThePicture)
{
    TestRun run;
    run.go("i { type image; field rho; range (1000 2000); }", 0.03);
    EXPECT_TRUE(run.dir.has("postProcessing/i/0/image_0.03.gp"));
    EXPECT_TRUE(run.dir.has("postProcessing/i/0/image_0.03_0.dat"));
    EXPECT_FALSE(run.dir.has("postProcessing/i/0/image_0.02.gp"));
    EXPECT_CONTAINS
    (
        run.dir.text("postProcessing/i/0/image_0.03.gp"), "[1000:2000]"
    );
    if (std::system("command -v gnuplot > /dev/null 2>&1") == 0)
    {
        const std::string png =
            run.dir.text("postProcessing/i/0/image_0.03.png");
        ASSERT_GT(png.size(), 1000u);
        EXPECT_EQ(png.substr(1, 3), "PNG");
    }
}


TEST(image, isMadeAtEveryCallWhereThatIsWanted)
{
    TestRun run;
    run.go("i { type image; when execute; executeInterval 2; }", 0.03);
    for (const std::string time : {"0", "0.02", "0.03"})
    {
        EXPECT_TRUE(run.dir.has("postProcessing/i/0/image_" + time + ".gp"));
    }
    EXPECT_FALSE(run.dir.has("postProcessing/i/0/image_0.01.gp"));
}


TEST(image, withoutGnuplotTheRunGoesOn)
{
    const std::string path = std::getenv("PATH");
    TestRun run;
    testing::internal::CaptureStderr();
    setenv("PATH", "/nowhere", 1);
    run.go("i { type image; when execute; }", 0.03);
    setenv("PATH", path.c_str(), 1);
    const std::string warnings = testing::internal::GetCapturedStderr();
    const auto first = warnings.find("gnuplot is not there");
    ASSERT_NE(first, std::string::npos);
    EXPECT_EQ
    (
        warnings.find("gnuplot is not there", first + 1), std::string::npos
    );
    EXPECT_TRUE(run.dir.has("postProcessing/i/0/image_0.03.gp"));
    EXPECT_FALSE(run.dir.has("postProcessing/i/0/image_0.03.png"));
}
