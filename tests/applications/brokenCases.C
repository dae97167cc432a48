// Mistakes in dictionaries: each is answered by a message that says what is
// wrong and where, and by exit code 1; nothing half written is left.
#include "applications/expectFailure.H"

using namespace sph;

static const std::string control = "system/controlDict";
static const std::string schemes = "system/sphSchemes";
static const std::string material = "constant/granularProperties";

TEST(brokenCases, misspeltKeyword)
{
    const AppCase broken;
    broken.replace(control, "\nmaxCo ", "\nmaxCoo ");
    expectFailure
    (
        broken, {"'maxCoo'", "not used", "did you mean 'maxCo'?"},
        control, "maxCoo"
    );
}

TEST(brokenCases, misspeltKeywordOfAModel)
{
    const AppCase broken;
    broken.replace(schemes, "hByDx", "hBydx");
    expectFailure
    (
        broken, {"'hBydx'", "not used", "did you mean 'hByDx'?"},
        schemes, "hBydx"
    );
}

TEST(brokenCases, misspeltEntryOfAFunction)
{
    const AppCase broken;
    broken.replace
    (
        control, "\nfunctions\\s*\\{",
        "\nfunctions\n{\n    extra\n    {\n        type fieldMinMax;\n"
        "        fields (U p);\n        excuteInterval 3;\n    }\n"
    );
    expectFailure
    (
        broken, {"'excuteInterval'", "did you mean 'executeInterval'?"}
    );
}

TEST(brokenCases, missingFile)
{
    const AppCase broken;
    broken.remove(material);
    expectFailure(broken, {"cannot find file", "granularProperties"});
    EXPECT_FALSE(broken.has("0"));
}

TEST(brokenCases, wrongDimensions)
{
    const AppCase broken;
    broken.replace
    (
        material, "\\[1 -3 0 0 0 0 0\\] 1612", "[1 -2 0 0 0 0 0] 1612"
    );
    expectFailure
    (
        broken, {"'rho0'", "[1 -2 0 0 0 0 0]", "expected", "[1 -3 0 0 0 0 0]"},
        material, "1612"
    );
}

TEST(brokenCases, unbalancedBrace)
{
    const AppCase broken;
    broken.append(schemes, "} // one too many");
    expectFailure
    (
        broken, {"Unexpected '}'", "no dictionary is open"},
        schemes, "one too many"
    );

    const AppCase open;
    open.replace(material, "\nrheology ", "\nunclosed {\nrheology ");
    expectFailure
    (
        open, {"The '{' of dictionary 'unclosed' is not closed"},
        material, "unclosed {"
    );
}

TEST(brokenCases, unknownModel)
{
    const AppCase broken;
    broken.set(material, "rheology", "muJ");
    expectFailure
    (
        broken,
        {
            "Unknown rheology type muJ", "did you mean 'muI'?",
            "Valid rheology types", "\nDruckerPrager\n", "\nNewtonian\n",
            "\nelastoViscoplasticMuI\n", "\nmuI\n"
        },
        material, "muJ"
    );
}

TEST(brokenCases, unreadableStartTime)
{
    const AppCase broken;
    broken.succeed("setParticles");
    broken.set(control, "startFrom", "startTime");
    broken.set(control, "startTime", "0.5");
    const Outcome absent = broken.run("granularFoamSPH");
    EXPECT_EQ(absent.code, 1);
    EXPECT_TRUE(says(absent, "There is no time folder 0.5"));
    EXPECT_TRUE(says(absent, "Available times : 0"));

    broken.set(control, "startTime", "zero");
    expectFailure
    (
        broken, {"'startTime' must be a number", "'zero'"}, control, "zero"
    );
}

TEST(brokenCases, negativeDensity)
{
    const AppCase broken;
    broken.replace(material, " 1612;", " -1612;");
    expectFailure
    (
        broken, {"'rho0' is -1612 but must be greater than 0"},
        material, "-1612"
    );
}

TEST(brokenCases, timeStepByHandTooLarge)
{
    const AppCase broken;
    broken.set(control, "adjustTimeStep", "no");
    broken.set(control, "deltaT", "1e-2");
    expectFailure
    (
        broken,
        {"deltaT 0.01 s is above the stable limit", "adjustTimeStep yes"},
        control, "deltaT 1e-2"
    );
}

TEST(brokenCases, coefficientsOfOtherModelsMayStandBy)
{
    const AppCase where;
    where.set
    (
        material, "rheology",
        "DruckerPrager;\nDruckerPragerCoeffs { mus 0.5; d 3e-4; rhos 2600; }\n"
        "Newtonian1 1"
    );
    expectFailure(where, {"'Newtonian1'", "not used"}, material, "Newtonian1");
    where.replace(material, "\nNewtonian1 1;", "");
    where.succeed("granularFoamSPH");

    where.replace
    (
        material, "\nelastoViscoplasticMuICoeffs",
        "\nelastoViscoplasticMuCoeffs"
    );
    expectFailure
    (
        where, {"did you mean 'elastoViscoplasticMuICoeffs'?"},
        material, "MuCoeffs"
    );
}
