#include "equationsOfState/EquationOfState.H"
#include "selection/listModels.H"
#include "support/Pairs.H"

#include <gtest/gtest.h>

namespace sph
{

namespace
{

struct shape : Selectable<shape, int>
{
    static constexpr const char* family = "testShape";
    virtual scalar area() const = 0;
};

struct square : shape
{
    const scalar a_;
    const int n_;
    square(const dictionary& dict, const int n)
    :
        a_(dict.get<scalar>("a")),
        n_(n)
    {}
    scalar area() const override { return n_*a_*a_; }
};

const shape::Add<square> addSquare("square", "four sides");

scalar area(const std::string& text)
{
    const dictionary dict = dictionary::fromString(text);
    return shape::New(dict, "shape", 2)->area();
}

} // namespace

TEST(selection, everyFamilyOfTheIssueOffersAChoice)
{
    const std::map<word, wordList> families =
    {
        {"kernel", {"cubicSpline", "WendlandC2", "quinticSpline"}},
        {"equationOfState", {"linear", "Tait"}},
        {
            "rheology",
            {
                "Newtonian", "muI", "elastoViscoplasticMuI", "DruckerPrager",
                "Bingham", "HerschelBulkley", "wellPosedMuI",
                "elastoViscoplasticHerschelBulkley",
                "elastoViscoplasticWellPosedMuI"
            }
        },
        {"viscousScheme", {"stressDivergence", "Morris", "Cleary"}},
        {"correction", {"none", "kernelGradient", "bulkBlended"}},
        {"stabilisation", {"none", "deltaSPH", "velocityPressureCoupling"}},
        {
            "boundary",
            {
                "noSlip", "freeSlip", "CoulombWall", "Morris", "symmetryPlane",
                "periodic"
            }
        },
        {"sideWalls", {"none", "Coulomb"}},
        {"turbulence", {"laminar", "Smagorinsky"}},
        {"integrator", {"symplecticEuler", "velocityVerlet"}},
        {"shifting", {"none", "strainRate"}},
        {"artificialViscosity", {"none", "Monaghan", "gradientCorrected"}}
    };
    for (const auto& [family, models] : families)
    {
        ASSERT_EQ(SelectionTables::all().count(family), 1u) << family;
        for (const word& model : models)
        {
            EXPECT_EQ(SelectionTables::all()[family].count(model), 1u)
                << family << ' ' << model;
        }
    }
}

TEST(selection, everyTableHoldsAtLeastTwoModelsWithADescription)
{
    for (const auto& [family, table] : SelectionTables::all())
    {
        // Families that tests make
        if (family.rfind("test", 0) == 0)
        {
            continue;
        }
        EXPECT_GE(table.size(), 2u) << family;
        for (const auto& [keyword, description] : table)
        {
            EXPECT_GT(description.size(), 5u) << family << ' ' << keyword;
        }
    }
}

TEST(selection, unknownKeywordListsTheValidOnesAndItsPlace)
{
    const dictionary dict = dictionary::fromString
    (
        "skin 0.2;\n\nkernel cubicSplin;\n", "system/sphSchemes"
    );
    try
    {
        Kernel::New(dict, "kernel", 1.0);
        FAIL() << "no error";
    }
    catch (const IOError& error)
    {
        const std::string text = error.block();
        for
        (
            const char* part :
            {
                "Unknown kernel type cubicSplin", "did you mean 'cubicSpline'",
                "WendlandC2", "quinticSpline", "system/sphSchemes", "line 3"
            }
        )
        {
            EXPECT_NE(text.find(part), std::string::npos)
                << part << " is missing in\n" << text;
        }
        EXPECT_EQ(error.startLine(), 3);
    }
}

TEST(selection, nothingIsSuggestedForAWordThatIsFarFromAll)
{
    try
    {
        make<Kernel>("Gauss;", 1.0);
        FAIL() << "no error";
    }
    catch (const IOError& error)
    {
        const std::string text = error.block();
        EXPECT_NE(text.find("Unknown kernel type Gauss"), std::string::npos);
        EXPECT_EQ(text.find("did you mean"), std::string::npos) << text;
    }
}

TEST(selection, aMissingKeywordIsAnError)
{
    const dictionary dict = dictionary::fromString("kernal cubicSpline;");
    EXPECT_THROW(Kernel::New(dict, "kernel", 1.0), IOError);
    EXPECT_NO_THROW(Kernel::New(dict, "kernel", "WendlandC2", 1.0));
}

TEST(selection, coefficientsStandBesideTheKeywordOrInTheirDictionary)
{
    EXPECT_EQ(area("shape square; a 3;"), 18);
    EXPECT_EQ(area("shape square; squareCoeffs { a 4; }"), 32);
    EXPECT_EQ(area("shape square; a 3; squareCoeffs { a 4; }"), 32);
    // of another model
    EXPECT_EQ(area("shape square; a 3; circleCoeffs { a 4; }"), 18);
    EXPECT_THROW(area("shape square; circleCoeffs { a 4; }"), IOError);
}

TEST(selection, coefficientsOfARealModel)
{
    const auto beside =
        make<EquationOfState>("Tait; K 2e5; gamma 3;", 1000.0, 9.81);
    const auto below =
        make<EquationOfState>("Tait; TaitCoeffs { K 2e5; gamma 3; }",
        1000.0, 9.81);
    EXPECT_EQ(beside->pressure(1100), below->pressure(1100));
    EXPECT_GT(beside->pressure(1100), 2e4);
}

TEST(selection, listModelsPrintsEveryModel)
{
    std::ostringstream os;
    listModels(os);
    for (const auto& [family, table] : SelectionTables::all())
    {
        EXPECT_NE(os.str().find(family + '\n'), std::string::npos);
        for (const auto& [keyword, description] : table)
        {
            EXPECT_NE(os.str().find(keyword), std::string::npos);
            EXPECT_NE(os.str().find(description), std::string::npos);
        }
    }
}

} // namespace sph
