#include "regions/Region.H"

#include <gtest/gtest.h>

using namespace sph;

namespace
{

void expectError(const std::string& text, const std::string& message)
{
    try
    {
        Region::New(dictionary::fromString(text, "setParticlesDict"));
        FAIL() << "no error for " << text;
    }
    catch (const IOError& error)
    {
        EXPECT_NE(error.block().find(message), std::string::npos)
            << error.block();
        EXPECT_NE(error.file().find("setParticlesDict"), std::string::npos);
        EXPECT_GT(error.startLine(), 0) << error.block();
    }
}

const std::string boxText = "type box; min (1 2 0); max (3 5 0);";

} // namespace


TEST(RegionErrors, nameTheEntryAndWhatIsWrong)
{
    expectError("type bix;", "Unknown region type bix");
    expectError("type bix;", "rotatedBox");
    expectError("type box; min (0 0 0);", "'max'");
    expectError
    (
        "type box; min (0 1 0); max (1 1 0);",
        "max must be greater than min in y"
    );
    expectError("type box; min (2 0 0); max (1 1 0);", "in x");
    expectError("type circle; centre (0 0 0); radius 0;", "radius");
    expectError
    (
        "type polygon; points ((0 0 0) (1 0 0));",
        "A polygon needs at least 3 points, not 2"
    );
    expectError
    (
        "type polygon; points ((0 0 0) (1 1 0) (1 0 0) (0 1 0));",
        "The polygon intersects itself: the side after point 0 meets the"
        " side after point 2"
    );
    expectError
    (
        "type polygon; points ((0 0 0) (2 0 0) (2 2 0) (1 0 0) (0 2 0));",
        "The polygon intersects itself"
    );
    expectError
    (
        "type polygon; points ((0 0 0) (2 0 0) (2 0 0) (0 2 0));",
        "Points 1 and 2 of the polygon are the same"
    );
    expectError
    (
        "type polygon; points ((0 0 0) (2 0 0) (1 0 0));", "folds back"
    );
    expectError
    (
        "type rotatedBox; origin (0 0 0); i (1 0 0); j (1 1 0);",
        "not at right angles"
    );
    expectError
    (
        "type rotatedBox; origin (0 0 0); i (0 0 0); j (1 1 0);",
        "The side i has no length"
    );
    expectError
    (
        "type union; regions (a {" + boxText + "});",
        "At least two regions are needed here, there is one"
    );
    expectError("type difference; regions ();", "there is none");
    expectError
    (
        "type union; regions ({" + boxText + "} { type cone; });",
        "Unknown region type cone"
    );
}
