#include "runoutLaws/RunoutLaw.H"

#include <cmath>
#include <gtest/gtest.h>

using namespace sph;

static std::unique_ptr<RunoutLaw> law(const std::string& text)
{
    return RunoutLaw::New(dictionary::fromString(text), "law");
}

// Values worked out by hand from reference/scaling_laws.csv
TEST(runoutLaws, haveThePublishedValues)
{
    const auto lube = law("law Lube2005;");
    EXPECT_NEAR(lube->runout(0.9).value, 1.08, 1e-12);
    EXPECT_NEAR(lube->runout(4.8).value, 5.406, 1e-3);
    EXPECT_NEAR(lube->height(0.9).value, 0.9, 1e-12);
    EXPECT_NEAR(lube->height(9).value, 2.408, 1e-3);
    EXPECT_NEAR(lube->stopTime(0.9).value, 3.2, 1e-12);

    const auto lajeunesse = law("law Lajeunesse2005;");
    EXPECT_NEAR(lajeunesse->runout(0.6).value, 1.08, 1e-12);
    EXPECT_NEAR(lajeunesse->runout(8).value, 10, 1e-9);
    EXPECT_NEAR(lajeunesse->height(0.5).value, 0.5, 1e-12);
    EXPECT_NEAR(lajeunesse->height(8).value, 1.8, 1e-9);

    const auto lagree = law("law Lagree2011;");
    EXPECT_NEAR(lagree->runout(0.5).value, 1.1, 1e-12);
    EXPECT_NEAR(lagree->runout(10).value, 19.546, 1e-3);
    EXPECT_NEAR(lagree->height(6.26).value, 1.2353, 1e-3);

    // a = 0.7: 0.2935 m beyond the gate and 0.1308 m high from 0.14 m
    const auto mangeney = law("law Mangeney2010;");
    EXPECT_NEAR(mangeney->runout(0.7).value, 0.29352/0.2, 1e-4);
    EXPECT_NEAR(mangeney->height(0.7).value, 0.13079/0.2, 1e-4);
    const auto slope = law("law Mangeney2010; theta 10;");
    EXPECT_FALSE(slope->runout(0.7).given());
    EXPECT_FALSE(slope->height(0.7).given());
}


TEST(runoutLaws, haveTheBandsOfTheirSources)
{
    const auto lajeunesse = law("law Lajeunesse2005;");
    EXPECT_DOUBLE_EQ(lajeunesse->runout(1).band, 0.12);
    EXPECT_DOUBLE_EQ(lajeunesse->runout(5).band, 0.14);
    EXPECT_DOUBLE_EQ(lajeunesse->height(5).band, 0.05);
    EXPECT_TRUE(std::isnan(law("law Lube2005;")->runout(0.9).band));
}


TEST(runoutLaws, sayWhereTheyInterpolateAcrossAGap)
{
    const auto lube = law("law Lube2005;");
    const LawValue middle = lube->runout(2.3);
    EXPECT_EQ(middle.note, "interpolated across the gap 1.8 < a < 2.8");
    EXPECT_GT(middle.value, lube->runout(1.8).value);
    EXPECT_LT(middle.value, lube->runout(2.8).value);
    // it joins both branches
    EXPECT_NEAR(lube->runout(1.8 + 1e-9).value, 1.2*1.8, 1e-6);
    EXPECT_NEAR
    (
        lube->runout(2.8 - 1e-9).value, 1.9*std::pow(2.8, 2.0/3), 1e-6
    );
    EXPECT_TRUE(lube->runout(1.7).note.empty());
    EXPECT_TRUE(lube->runout(2.9).note.empty());
}


TEST(runoutLaws, haveNoValueInTheGapWhereThatIsWanted)
{
    const auto lube = law("law Lube2005; Lube2005Coeffs { gap noLaw; }");
    EXPECT_FALSE(lube->runout(2.3).given());
    EXPECT_NE(lube->runout(2.3).note.find("no law"), std::string::npos);
    EXPECT_TRUE(lube->runout(1.7).given());
    EXPECT_THROW(law("law Lube2005; gap maybe;"), IOError);
}


TEST(runoutLaws, sayWhereTheDataEnd)
{
    const auto lube = law("law Lube2005;");
    EXPECT_TRUE(lube->runout(30).given());
    EXPECT_NE(lube->runout(30).note.find("20"), std::string::npos);
    EXPECT_FALSE(law("law Lagree2011;")->height(0.5).given());
    EXPECT_FALSE(law("law none;")->runout(1).given());
}


TEST(runoutLaws, unknownNameListsTheLaws)
{
    try
    {
        law("law Lube2004;");
        FAIL();
    }
    catch (const IOError& error)
    {
        EXPECT_NE(error.block().find("Lube2005"), std::string::npos);
        EXPECT_NE(error.block().find("Lajeunesse2005"), std::string::npos);
    }
}
