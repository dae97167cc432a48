#include "support.H"

using namespace sph;

namespace
{

scalar read(const std::string& value, const dimensionSet& dims)
{
    return parse("x " + value + ";").get("x", dims);
}

void expectRefused
(
    const std::string& value, const dimensionSet& dims,
    const std::string& message
)
{
    SCOPED_TRACE(value);
    const auto dict = parse("a 1;\nx " + value + ";");
    expectError(2, message, [&] { dict.get("x", dims); });
}

} // namespace

TEST(DictionaryDimensions, mayBeLeftOut)
{
    EXPECT_EQ(read("3", dimLength), 3);
    EXPECT_EQ(read("h 3", dimLength), 3);
    EXPECT_EQ(read("h [0 1 0 0 0 0 0] 3", dimLength), 3);
    EXPECT_EQ(read("[0 1 0 0 0] 3", dimLength), 3);
    EXPECT_EQ(read("[] 3", dimless), 3);
}

TEST(DictionaryDimensions, ofUnitsAreScaledToSI)
{
    EXPECT_DOUBLE_EQ(read("[mm] 3", dimLength), 3e-3);
    EXPECT_DOUBLE_EQ(read("[g cm^-3] 1.6", dimDensity), 1600);
    EXPECT_DOUBLE_EQ(read("[kg/m^3] 1600", dimDensity), 1600);
    EXPECT_DOUBLE_EQ(read("[kPa] 5", dimPressure), 5000);
    EXPECT_DOUBLE_EQ(read("[MPa] 5", dimPressure), 5e6);
    EXPECT_DOUBLE_EQ(read("[N/m^2] 5", dimPressure), 5);
    EXPECT_DOUBLE_EQ(read("[Pa s] 5", dimDynamicViscosity), 5);
    EXPECT_DOUBLE_EQ(read("[mPa*s] 5", dimDynamicViscosity), 5e-3);
    EXPECT_DOUBLE_EQ(read("[ms] 5", dimTime), 5e-3);
    EXPECT_DOUBLE_EQ(read("[1/s] 5", dimRate), 5);
    EXPECT_DOUBLE_EQ(read("[kg/(m s)] 5", dimDynamicViscosity), 5);
    EXPECT_DOUBLE_EQ(read("[m^2 Hz] 5", dimKinematicViscosity), 5);
    EXPECT_DOUBLE_EQ(read("[m^0.5 m^(1.5)/s] 5", dimKinematicViscosity), 5);
}

TEST(DictionaryDimensions, ofAnotherKindAreRefused)
{
    expectRefused("[m] 3", dimTime, "The dimensions [0 1 0 0 0 0 0]");
    expectRefused("[m] 3", dimTime, "expected dimensions [0 0 1 0 0 0 0]");
    expectRefused("[0 1 0 0 0 0 0] 3", dimTime, "[0 1 0 0 0 0 0]");
    expectRefused("[0 1] 3", dimLength, "5 or 7 exponents");
    expectRefused("[furlong] 3", dimLength, "unknown unit 'furlong'");
    expectRefused("[m^] 3", dimLength, "cannot be read");
    expectRefused("[kg/(m s] 3", dimLength, "cannot be read");
    expectRefused("[m] (1 2 0)", dimLength, "must be a number");
    expectRefused("[m]", dimLength, "nothing after");
    expectRefused("3 junk", dimLength, "1 excess token: 'junk'");
}

TEST(DictionaryDimensions, ofVectors)
{
    const auto dict = parse("g g [cm/s^2] (0 -981 0);");
    EXPECT_TRUE
    (
        dict.getVector("g", dimAcceleration).isApprox(vector(0, -9.81))
    );
    EXPECT_THROW(dict.getVector("g", dimVelocity), IOError);
}

TEST(DictionaryDimensions, areAnEntryOfTheirOwn)
{
    const auto dict = parse("dimensions [0 1 -2 0 0 0 0];");
    EXPECT_TRUE(dict.get<dimensionSet>("dimensions") == dimAcceleration);
    EXPECT_TRUE(dict.get<dimensionSet>("dimensions") != dimVelocity);
    EXPECT_EQ(dimAcceleration.str(), "[0 1 -2 0 0 0 0]");
    EXPECT_EQ(dimensionSet(0.5, 0, 0).str(), "[0.5 0 0 0 0 0 0]");
}

TEST(DictionaryRanges, areCheckedInSI)
{
    const auto dict = parse("rho -1;\nd [mm] 2;\nphi 1;");
    expectError
    (
        1, "Entry 'rho' is -1 but must be greater than 0",
        [&] { dict.get("rho", dimDensity, Range::positive()); }
    );
    EXPECT_DOUBLE_EQ(dict.get("d", dimLength, Range::between(0, 1)), 2e-3);
    expectError
    (
        2, "must be at least 1",
        [&] { dict.get("d", dimLength, Range{1}); }
    );
    EXPECT_EQ(dict.get("phi", dimless, Range::between(0, 1)), 1);
    expectError
    (
        3, "at least 0 and less than 1",
        [&] { dict.get("phi", dimless, Range{0, 1, true, false}); }
    );
}

TEST(DictionaryRanges, saysWhatTheyAre)
{
    EXPECT_EQ(Range::positive().str(), "greater than 0");
    EXPECT_EQ(Range::nonNegative().str(), "at least 0");
    EXPECT_EQ(Range::between(0, 0.5).str(), "from 0 to 0.5");
    Range below;
    below.max = 3;
    EXPECT_EQ(below.str(), "at most 3");
    below.maxAllowed = false;
    EXPECT_EQ(below.str(), "less than 3");
}
