// Function objects over the times that a run has written.
#include "applications/AppCase.H"

using namespace sph;

namespace
{

// The rows of a .dat file, as they stand there
wordList rows(const AppCase& where, const std::string& name)
{
    wordList list;
    std::istringstream is(where.text("postProcessing/" + name));
    for (word line; std::getline(is, line); )
    {
        if (line[0] != '#')
        {
            list.push_back(line);
        }
    }
    return list;
}

std::vector<scalar> numbers(const word& row)
{
    std::istringstream is(row);
    return {std::istream_iterator<scalar>(is), {}};
}

// Particles are sorted when a run begins: sums are the same to rounding
void expectNear(const word& a, const word& b)
{
    const auto x = numbers(a), y = numbers(b);
    ASSERT_EQ(x.size(), y.size());
    for (std::size_t c = 0; c < x.size(); ++c)
    {
        EXPECT_NEAR(x[c], y[c], 1e-8*(1 + std::abs(y[c]))) << "column " << c;
    }
}

// A case with the times 0, 0.01 and 0.02
struct Written : AppCase
{
    Written()
    {
        succeed("setParticles");
        succeed("granularFoamSPH");
    }

    void addFunction(const std::string& text) const
    {
        replace("system/controlDict", "functions\n\\{", "functions\n{" + text);
    }

    void fails(const std::string& options, const std::string& part) const
    {
        const Outcome outcome = run("granularFoamSPH " + options);
        EXPECT_EQ(outcome.code, 1);
        EXPECT_TRUE(says(outcome, part));
    }
};

} // namespace


TEST(postProcess, measuresWhatTheRunAndPostRunoutMeasured)
{
    const Written where;
    const Outcome outcome = where.succeed("granularFoamSPH -postProcess");
    EXPECT_FALSE(contains(outcome.text, "Starting time loop"));
    where.succeed("postRunout");
    for (const word name : {"energies", "runout"})
    {
        const auto run = rows(where, name + "/0/" + name + ".dat");
        const auto after = rows(where, name + "/0_1/" + name + ".dat");
        ASSERT_EQ(after.size(), 3u) << outcome.text;
        expectNear(after.front(), run.front());
        expectNear(after.back(), run.back());
    }
    const auto after = rows(where, "runout/0_1/runout.dat");
    const auto report = rows(where, "postRunout/0/runout.dat");
    ASSERT_EQ(report.size(), after.size());
    for (std::size_t k = 0; k < after.size(); ++k)
    {
        const auto a = numbers(after[k]), b = numbers(report[k]);
        EXPECT_EQ(a, std::vector<scalar>(b.begin(), b.begin() + a.size()));
    }
}


TEST(postProcess, selectsTimesAndObjects)
{
    const Written where;
    where.succeed("granularFoamSPH -postProcess -latestTime -func energies");
    EXPECT_EQ(rows(where, "energies/0.02/energies.dat").size(), 1u);
    EXPECT_FALSE(where.has("postProcessing/runout/0.02"));

    where.succeed("granularFoamSPH -postProcess -time 0.005: -func runout");
    EXPECT_EQ(rows(where, "runout/0.01/runout.dat").size(), 2u);

    // a type that is no entry, and one that is a file each time
    where.succeed("granularFoamSPH -postProcess -noZero -func surfaceLine");
    EXPECT_TRUE(where.has("postProcessing/surfaceLine/0.01/surface_0.02.dat"));

    where.fails("-postProcess -time 5", "No time 5 was written");
    where.fails("-latestTime", "goes with -postProcess");
    where.fails("-postProcess -func momentum", "Unknown function object");
    where.fails("-postProcess -func momentum", "stopWhenAtRest");
    where.fails("-postProcess -func probes", "probeLocations");
}


TEST(postProcess, executesSeveralByName)
{
    const Written where;
    const std::string post = "-postProcess -noZero ";
    where.succeed
    (
        "granularFoamSPH " + post + "-funcs '(energies surfaceLine)'"
    );
    EXPECT_EQ(rows(where, "energies/0.01/energies.dat").size(), 2u);
    EXPECT_TRUE(where.has("postProcessing/surfaceLine/0.01/surface_0.02.dat"));
    EXPECT_FALSE(where.has("postProcessing/runout/0.01"));

    where.succeed("granularFoamSPH " + post + "-func runout -funcs '(energies)'");
    EXPECT_EQ(rows(where, "runout/0.01/runout.dat").size(), 2u);
    EXPECT_EQ(rows(where, "energies/0.01_1/energies.dat").size(), 2u);

    where.fails(post + "-funcs '(energies energies)'", "is named twice");
    where.fails(post + "-funcs '(energies momentum)'", "momentum");
    where.fails(post + "-funcs '()'", "names no function object");
    where.fails(post + "-funcs energies", "a list in parentheses");
    where.fails("-funcs '(energies)'", "goes with -postProcess");
}


TEST(postProcess, saysWhatIsInNoFile)
{
    const Written where;
    where.addFunction
    (
        "rates { type probes; fields (gradU); probeLocations ((0 0 0)); }"
        "walls { type forces; patches (bed); }"
    );
    where.fails("-postProcess -func walls", "only a run has them");
    where.fails
    (
        "-postProcess -func rates", "gradU was not written at time 0"
    );
    where.fails("-postProcess -func rates", "gammaDot");
    where.succeed("granularFoamSPH -postProcess -func energies");
}


TEST(postProcess, refusesEntriesThatNobodyReads)
{
    const Written where;
    where.addFunction("e { type energies; executeIntervall 3; }");
    where.fails("-postProcess", "executeInterval");
    where.fails("-postProcess -func e", "executeInterval");
    where.succeed("granularFoamSPH -postProcess -func runout");
}


TEST(postProcess, listFunctionObjectsListsNothingElse)
{
    const Outcome outcome =
        AppCase().succeed("granularFoamSPH -listFunctionObjects");
    for (const char* type : {"runout", "probes", "sets", "forces"})
    {
        EXPECT_TRUE(says(outcome, "\n    " + word(type) + "  "));
    }
    EXPECT_FALSE(contains(outcome.text, "cubicSpline"));
}


TEST(postProcess, marksWhereTheLawIsIllPosed)
{
    const Written where;
    where.succeed("granularFoamSPH -postProcess -func illPosed -latestTime");
    const auto after = rows(where, "illPosed/0.02/illPosed.dat");
    ASSERT_EQ(after.size(), 1u);
    const auto row = numbers(after[0]);
    ASSERT_EQ(row.size(), 3u);
    EXPECT_GT(row[1], 0) << "some flows";
    EXPECT_LE(row[1], 1);
    EXPECT_LE(row[2], row[1]) << "what is ill-posed flows";

    where.replace
    (
        "constant/granularProperties", "rheology  *elastoViscoplasticMuI;",
        "rheology Newtonian; NewtonianCoeffs { eta 1; }"
    );
    where.fails("-postProcess -func illPosed", "no mu(I)");
}
