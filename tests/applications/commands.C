// What the applications print for those who ask, and the check of postRunout.
#include "applications/AppCase.H"

using namespace sph;

TEST(commands, listModelsPrintsEveryFamily)
{
    const Outcome outcome = AppCase().succeed("granularFoamSPH -listModels");
    const std::map<word, wordList> families
    {
        {"kernel", {"cubicSpline", "WendlandC2", "quinticSpline"}},
        {"equationOfState", {"linear", "Tait"}},
        {
            "rheology",
            {"Newtonian", "muI", "elastoViscoplasticMuI", "DruckerPrager"}
        },
        {"viscousScheme", {"Morris", "Cleary", "stressDivergence"}},
        {"correction", {"none", "kernelGradient", "bulkBlended"}},
        {"stabilisation", {"none", "deltaSPH", "velocityPressureCoupling"}},
        {
            "boundary",
            {"noSlip", "Morris", "freeSlip", "symmetryPlane", "periodic"}
        },
        {"turbulence", {"laminar", "Smagorinsky"}},
        {"integrator", {"symplecticEuler", "velocityVerlet"}},
        {"functionObject", {"runout", "energies", "stopWhenAtRest"}},
        {"shifting", {"none", "strainRate"}},
        {"geometryFormat", {"csv", "stl", "vtk", "vtp"}},
        {"artificialViscosity", {"none", "gradientCorrected"}}
    };
    for (const auto& [family, models] : families)
    {
        const std::string head = '\n' + family + '\n';
        const auto begin = ('\n' + outcome.text).find(head);
        ASSERT_NE(begin, std::string::npos) << family;
        const std::string table = outcome.text.substr
        (
            begin, outcome.text.find("\n\n", begin) - begin
        );
        for (const word& model : models)
        {
            EXPECT_CONTAINS(table, "\n    " + model + "  ");
        }
    }
}

TEST(commands, listFunctionObjectsPrintsThoseOfTheCase)
{
    const AppCase where;
    where.replace
    (
        "system/controlDict", "functions\n\\{",
        "functions\n{ bottom { type fieldMinMax; fields (p); }"
    );
    const std::string text =
        where.succeed("granularFoamSPH -listFunctionObjects").text;
    EXPECT_CONTAINS(text, "functionObject\n    energies  ");
    EXPECT_CONTAINS(text, "functions of system/controlDict\n    bottom  ");
}

TEST(commands, helpNamesTheOptions)
{
    const AppCase where;
    for (const char* app : {"setParticles", "granularFoamSPH", "postRunout"})
    {
        const Outcome outcome = where.succeed(std::string(app) + " -help");
        EXPECT_TRUE(says(outcome, std::string("Usage: ") + app));
        EXPECT_TRUE(says(outcome, "-case <dir>"));

        const Outcome wrong = where.run(std::string(app) + " -cse x");
        EXPECT_EQ(wrong.code, 1);
        EXPECT_TRUE(says(wrong, "did you mean '-case'?"));
    }
}

TEST(commands, caseInAFolderWithBlanks)
{
    const AppCase where;
    const auto blanks = where.dir()/"my first case";
    std::filesystem::create_directory(blanks);
    for (const char* folder : {"constant", "system"})
    {
        std::filesystem::rename(where.dir()/folder, blanks/folder);
    }
    for (const char* app : {"setParticles", "granularFoamSPH", "postRunout"})
    {
        where.succeed(std::string(app) + " -case '" + blanks.string() + '\'');
    }
    EXPECT_CONTAINS
    (
        where.text("my first case/VTK/my first case.vtp.series"),
        "{\"name\": \"../0.02/granular.vtp\", \"time\": 0.02}"
    );
}

TEST(commands, purgeWriteKeepsTheLastTimes)
{
    const AppCase where;
    where.append("system/controlDict", "purgeWrite 2;");
    where.set("system/controlDict", "writeInterval", "0.005");
    where.succeed("setParticles");
    where.succeed("granularFoamSPH");
    std::string names;
    for (const auto& time : Time::findTimes(where.dir()))
    {
        names += time.name + ' ';
    }
    EXPECT_EQ(names, "0 0.015 0.02 ");
    const std::string name = where.dir().filename().string();
    const std::string series = where.text("VTK/" + name + ".vtp.series");
    EXPECT_CONTAINS(series, "0.015/granular.vtp");
    EXPECT_FALSE(contains(series, "0.005/"));
}

TEST(commands, postRunoutChecksTheBands)
{
    const AppCase where;
    where.succeed("setParticles");
    where.succeed("granularFoamSPH");

    const std::string dict = "system/postRunoutDict";
    where.replace(dict, "band[^}]*\\}", "band { runout 100; height 100; }");
    const Outcome passed = where.succeed("postRunout -check");
    EXPECT_TRUE(says(passed, "\n2 passed, 0 failed\n"));

    // The run ends long before the deposit has spread
    where.replace(dict, "band[^}]*\\}", "band { runout 0.1; height 100; }");
    const Outcome failed = where.run("postRunout -check");
    EXPECT_EQ(failed.code, 1);
    EXPECT_TRUE(says(failed, "\n1 passed, 1 failed\n"));

    // Three times this threshold is more than the height
    EXPECT_TRUE(says(failed, "Run-out with three times the threshold: "));
    where.set(dict, "threshold", "0.04");
    EXPECT_FALSE(contains(where.run("postRunout").text, "nan"));

    where.set(dict, "law", "Lube205");
    const Outcome unknown = where.run("postRunout -check");
    EXPECT_EQ(unknown.code, 1);
    EXPECT_TRUE(says(unknown, "did you mean 'Lube2005'?"));
    EXPECT_TRUE
    (
        says
        (
            unknown,
            "line " + std::to_string(where.line(dict, "Lube205"))
        )
    );
}
