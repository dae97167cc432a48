#include "setup/Filled.H"

using namespace sph;

namespace
{

const std::string a = "a { type box; min (0 0 0); max (1 1 0); }\n";
const std::string b = "b { type box; min (0.55 0.05 0); max (2.05 1.05 0); }\n";
const std::string beside = "c { type box; min (1 0 0); max (2 1 0); }\n";

} // namespace


TEST(FillRegions, reportsTheAreaThatIsMissed)
{
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    Filled filled("regions (a { type box; min (0 0 0); max (1.04 1 0); });");
    const std::string log = testing::internal::GetCapturedStdout();
    const std::string warnings = testing::internal::GetCapturedStderr();
    EXPECT_EQ(filled.count(0), 100u);
    EXPECT_NE(log.find("area 1.04 m2, particles 1 m2, -3.84615 %"),
        std::string::npos) << log;
    EXPECT_NE(warnings.find("'a' take 3.84615 % less"), std::string::npos)
        << warnings;
}

TEST(FillRegions, doesNotWarnOfAnExactFit)
{
    testing::internal::CaptureStderr();
    Filled filled("regions (" + a + beside + ");");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(filled.count(0), 100u);
    EXPECT_EQ(filled.count(1), 100u);
}

TEST(FillRegions, refusesWhatCannotBeFilled)
{
    expectError([]{ Filled("regions ();"); }, {"no region to be filled"}, 2);
    expectError([]{ Filled("overlap error;"); }, {"regions"});
    expectError
    (
        []
        {
            Filled
            (
                "regions\n(\n"
                "dot { type circle; centre (0 0 0); radius 0.01; }\n);"
            );
        },
        {"The region 'dot' holds no particle", "spacing of 0.1 m"}, 4
    );
    expectError
    (
        []{ Filled("regions\n(\n" + a + a + ");"); },
        {"There are two regions 'a'"}, 5
    );
}

TEST(FillRegions, refusesASpacingInTheWrongUnit)
{
    expectError
    (
        []
        {
            Filled filled
            (
                "regions ({ type box; min (0 0 0); max (1e4 1e4 0); });"
            );
        },
        {"spacing of 0.1 m is too small for the region '0'"}, 1
    );
}

TEST(Overlap, isAnErrorThatNamesBothRegionsAndTheCount)
{
    // Columns of b at 0.6 0.7 0.8 0.9 and on the border of a, rows at 0.1 to
    // 0.9 lie inside a; those at 1.0 are outside and 0.07 from the nearest
    expectError
    (
        []{ Filled("regions\n(\n" + a + b + ");"); },
        {
            "The regions 'a' and 'b' overlap: 36 particles of 'b'",
            "overlap first;"
        },
        5
    );
}

TEST(Overlap, isFoundOutsideTheShapesToo)
{
    // 0.04 apart across the common border: none lies inside the other
    const std::string near =
        "regions ({ type box; min (0 0 0); max (0.96 1 0); }"
        "{ type box; min (0.944 0 0); max (1.944 1 0); });";
    expectError([&]{ Filled filled(near); }, {"'0' and '1' overlap: 10"});
}

TEST(Overlap, firstAndLastKeepTheirParticles)
{
    const std::string both = "regions (" + a + b + ");";
    const Filled first("overlap first;" + both);
    EXPECT_EQ(first.count(0), 100u);
    EXPECT_EQ(first.count(1), 150u - 36u);

    const Filled last("overlap last;" + both);
    EXPECT_LT(last.count(0), 100u);
    EXPECT_EQ(last.count(1), 150u);
    for (const vector& point : last.regions[0].points)
    {
        EXPECT_FALSE(last.regions[1].region->inside(point));
    }
}

TEST(Overlap, whatWasTakenAwayTakesNothingAway)
{
    // One column of b is too close to a; the lower particle of c is close to
    // the top of that column only
    const Filled filled
    (
        "overlap first; regions ("
        "a { type box; min (0 0 0); max (0.96 0.96 0); }"
        "b { type box; min (0.944 0 0); max (1.144 0.96 0); }"
        "c { type box; min (0.96 0.93 0); max (1.06 1.13 0); });"
    );
    EXPECT_EQ(filled.count(0), 100u);
    EXPECT_EQ(filled.count(1), 10u);
    EXPECT_EQ(filled.count(2), 2u);
}

TEST(Overlap, adjoiningRegionsDoNotOverlap)
{
    EXPECT_NO_THROW(Filled("regions (" + a + beside + ");"));
}

TEST(Overlap, aRegionThatLosesEverythingIsAnError)
{
    expectError
    (
        []
        {
            Filled
            (
                "overlap first; regions (" + a
              + "in { type box; min (0.2 0.2 0); max (0.8 0.8 0); });"
            );
        },
        {"'in' holds no particle: other regions take all of its places"}
    );
}

TEST(Overlap, anUnknownRuleIsRefused)
{
    expectError
    (
        []{ Filled("overlap both; regions (" + a + ");"); },
        {"overlap", "first", "last"}, 2
    );
}
