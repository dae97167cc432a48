// Ways to break a case: each is answered by a message that says what is wrong
// and where, and by exit code 1; nothing half written is left.
#include "applications/AppCase.H"

using namespace sph;

namespace
{

const std::string control = "system/controlDict";
const std::string setup = "system/setParticlesDict";
const std::string schemes = "system/sphSchemes";
const std::string material = "constant/granularProperties";

// The applications, one after the other, until one fails
Outcome runAll(const AppCase& broken)
{
    Outcome outcome = broken.run("setParticles");
    return outcome.code == 0 ? broken.run("granularFoamSPH") : outcome;
}

// Runs a case that must fail with all these words, and the line in the file
// on which the given text stands
void expectFailure
(
    const AppCase& broken, const wordList& words,
    const std::string& file = "", const std::string& textOfLine = ""
)
{
    const Outcome outcome = runAll(broken);
    EXPECT_EQ(outcome.code, 1) << outcome.text;
    EXPECT_TRUE(says(outcome, "--> FOAM FATAL "));
    EXPECT_TRUE(says(outcome, " exiting"));
    for (const word& text : words)
    {
        EXPECT_TRUE(says(outcome, text));
    }
    if (!file.empty())
    {
        EXPECT_TRUE(says(outcome, "file: " + (broken.dir()/file).string()));
        const std::string number =
            std::to_string(broken.line(file, textOfLine));
        const std::regex place(" line " + number + "(\\.| to line )");
        EXPECT_TRUE(std::regex_search(outcome.text, place))
            << "not line " << number << ":\n" << outcome.text;
    }
    EXPECT_FALSE(broken.hasTemporary());
}

} // namespace

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

TEST(brokenCases, startTimeWithoutParticles)
{
    const AppCase broken;
    const Outcome outcome = broken.run("granularFoamSPH");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_TRUE(says(outcome, "There is no time folder"));
    EXPECT_TRUE(says(outcome, "Run setParticles first"));
}

TEST(brokenCases, zeroSpacing)
{
    const AppCase broken;
    broken.set(setup, "spacing", "0");
    expectFailure
    (
        broken, {"'spacing' is 0 but must be greater than 0"},
        setup, "spacing 0"
    );
    EXPECT_FALSE(broken.has("0"));
}

TEST(brokenCases, overlappingRegions)
{
    const AppCase broken;
    broken.replace
    (
        setup, "\n\\);",
        "\n    second\n    {\n        type box;\n"
        "        min (0.05 0 0);\n        max (0.15 0.05 0);\n    }\n);"
    );
    expectFailure
    (
        broken,
        {"'column' and 'second' overlap", "25 particles", "overlap first;"},
        setup, "    second"
    );
    EXPECT_FALSE(broken.has("0"));
}

// Tests may run as root: a file stands where a folder is to be made
TEST(brokenCases, unwritableFolder)
{
    const AppCase broken;
    broken.succeed("setParticles");
    const std::string start = broken.text("0/granular.vtp");
    broken.write("0.01", "");
    const Outcome outcome = broken.run("granularFoamSPH");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_TRUE(says(outcome, "Cannot write"));
    EXPECT_TRUE(says(outcome, (broken.dir()/"0.01").string()));
    EXPECT_TRUE(says(outcome, "Not a directory"));
    EXPECT_TRUE(broken.text("0/granular.vtp") == start);

    broken.remove("0");
    broken.write("0", "");
    expectFailure(broken, {"Cannot write", (broken.dir()/"0").string()});
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

TEST(brokenCases, emptyColumn)
{
    const AppCase broken;
    broken.replace(setup, "\\$h0 0\\)", "0 0)");
    expectFailure
    (
        broken, {"The box is empty", "max must be greater than min in y"},
        setup, "($r0 0 0)"
    );
    EXPECT_FALSE(broken.has("0"));
}

TEST(brokenCases, particlesOutsideOfAPeriodicPatch)
{
    const AppCase broken;
    broken.write
    (
        "constant/boundary",
        "ends { type periodic; point (0 0 0); translation (0.05 0 0); }\n"
    );
    expectFailure
    (
        broken, {"45 of 90", "'column'", "not between the planes", "'ends'"}
    );
}

TEST(brokenCases, boundaryChangedAfterSetParticles)
{
    const AppCase broken;
    broken.succeed("setParticles");
    const std::string walls = broken.text("0/walls.vtp");

    broken.remove("0/walls.vtp");
    const Outcome without = broken.run("granularFoamSPH");
    EXPECT_EQ(without.code, 1);
    EXPECT_TRUE(says(without, "walls.vtp is missing"));

    broken.write("0/walls.vtp", walls);
    broken.succeed("granularFoamSPH");
    broken.replace("constant/boundary", "\\(0.35 0 0\\)", "(0.36 0 0)");
    const Outcome moved = broken.run("granularFoamSPH");
    EXPECT_EQ(moved.code, 1);
    EXPECT_TRUE(says(moved, "constant/boundary"));
    EXPECT_TRUE(says(moved, "Run setParticles again"));
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

// New particles, and the times of an earlier run beside them
TEST(brokenCases, laterTimesOfAnEarlierRun)
{
    const AppCase where;
    EXPECT_FALSE(says(where.succeed("setParticles"), "Warning"));
    where.succeed("granularFoamSPH");
    const Outcome outcome = where.succeed("setParticles");
    EXPECT_TRUE(says(outcome, "Times of an earlier run are there: 0.01 0.02"));
    EXPECT_TRUE(says(outcome, "startFrom latestTime"));
}
