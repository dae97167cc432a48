// The function object profile: columns, and the error against a reference.
#include "TestRun.H"

using namespace sph;

namespace
{

// A column of 0.1 m, 20 rows, that shears with U.x = k y
struct Sheared : TestRun
{
    explicit Sheared(const scalar k)
    {
        for (label i = 0; i < particles.granular().size(); ++i)
        {
            particles.U.x[i] = k*particles.r.y[i];
        }
        dir.write("exact.csv", "t,y,u\n1,0,7\n1,1,7\n0.01,0,0\n0.01,1,2\n");
    }
};

const std::string reference =
    "reference { file exact.csv; columns (y u); field U.x; ";

} // namespace


TEST(profile, writesTheMeansOfRows)
{
    Sheared run(2);
    run.go("layer { type profile; fields (U p); }", 0.01);
    const wordList columns{"z", "volume", "U.x", "U.y", "p"};
    EXPECT_EQ(run.columns("layer/0/profile_0.01.dat"), columns);
    const auto rows = run.rows("layer/0/profile_0.01.dat");
    ASSERT_EQ(rows.size(), 20u);
    for (std::size_t k = 0; k < rows.size(); ++k)
    {
        EXPECT_NEAR(rows[k][0], 0.005*(k + 0.5), 1e-9);
        EXPECT_NEAR(rows[k][2], 2*rows[k][0], 1e-8);
        EXPECT_NEAR(rows[k][3], 0, 1e-12);
    }
}

// Twice 5 % off: 5 % in L2, and a band on either side of it
TEST(profile, measuresTheErrorInL2)
{
    for (const bool wide : {true, false})
    {
        Sheared run(2.1);
        run.go
        (
            "layer { type profile; fields (U); " + reference
          + "where { t 0.01; } band " + (wide ? "0.051" : "0.049") + "; } }",
            0.01
        );
        const std::string text =
            run.dir.text("postProcessing/layer/0/reference.dat");
        EXPECT_NE
        (
            text.find(wide ? "passed" : "failed"), std::string::npos
        ) << text;
        const std::string last = text.substr(text.rfind('\n', text.size() - 2));
        std::istringstream is(last);
        word verdict;
        scalar time, measured, exact, L2, band;
        is >> verdict >> time >> measured >> exact >> L2 >> band;
        EXPECT_NEAR(time, 0.01, 1e-12);
        EXPECT_NEAR(measured/exact, 1.05, 1e-6);
        EXPECT_NEAR(L2, 5, 1e-5);
        EXPECT_NEAR(band, wide ? 5.1 : 4.9, 1e-9);
    }
}

TEST(profile, comparesAtTheTimesOfTheFile)
{
    Sheared run(2);
    run.go
    (
        "layer { type profile; fields (U); " + reference + "time t; } }", 0.03
    );
    const std::string text =
        run.dir.text("postProcessing/layer/0/reference.dat");
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3) << text;
    EXPECT_NE(text.find("none"), std::string::npos) << text;
}

TEST(profile, refusesWhatItDoesNotKnow)
{
    const auto message = [](const std::string& entries)
    {
        Sheared run(2);
        try
        {
            run.go("layer { type profile; fields (U); " + entries + " }", 0.01);
        }
        catch (const Error& error)
        {
            return error.block();
        }
        return std::string();
    };
    const auto says = [&](const std::string& entries, const char* part)
    {
        EXPECT_NE(message(entries).find(part), std::string::npos)
            << message(entries);
    };
    says("width 0;", "greater than 0");
    says("direction (0 0 0);", "must not be zero");
    says("reference { file no.csv; columns (y u); field U.x; }", "no.csv");
    says("reference { file exact.csv; columns (y v); field U.x; }", "column v");
    says("reference { file exact.csv; columns (y u); field U; }", "U.x");
    says(reference + "where { t 5; } }", "No row");
    EXPECT_EQ(message(reference + "where { t 1; } }"), "");
}
