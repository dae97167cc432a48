// What a dry run says and leaves alone, and what a run can be repeated from.
#include "applications/StateFiles.H"

#include <set>

using namespace sph;

namespace
{

std::set<std::string> filesOf(const AppCase& where)
{
    std::set<std::string> files;
    using Walk = std::filesystem::recursive_directory_iterator;
    for (const auto& entry : Walk(where.dir()))
    {
        files.insert(entry.path().string());
    }
    return files;
}

} // namespace

TEST(settings, dryRunReadsAllAndWritesNothing)
{
    const AppCase where;
    where.succeed("setParticles");
    const auto before = filesOf(where);
    const Outcome outcome = where.succeed("granularFoamSPH -dry-run");
    for
    (
        const char* text :
        {
            "// * * * constant/granularProperties",
            "// * * * system/sphSchemes",
            "executeControl  timeStep;    // default",
            "Particles: ", "particle-steps/s, measured", "Steps to endTime: ",
            "Memory: ", "Time: "
        }
    )
    {
        EXPECT_TRUE(says(outcome, text));
    }
    EXPECT_FALSE(contains(outcome.text, "Starting time loop"));
    EXPECT_EQ(filesOf(where), before);
}

TEST(settings, dryRunMeetsMistakesAsARun)
{
    const AppCase where;
    where.succeed("setParticles");
    where.append("system/sphSolution", "skim 0.2;");
    const Outcome outcome = where.run("granularFoamSPH -dry-run");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_TRUE(says(outcome, "skim"));
    EXPECT_TRUE(says(outcome, "sphSolution"));
}

TEST(settings, runWithTheEffectiveOnesGivesTheSame)
{
    const AppCase where;
    where.succeed("setParticles");
    where.succeed("granularFoamSPH");
    const auto state = stateOf(where, "0.02");
    where.remove("0.02");
    where.remove("0.01");
    for (const word& folder : wordList{"constant", "system"})
    {
        std::filesystem::copy
        (
            where.dir()/"effective"/"0"/folder, where.dir()/folder,
            std::filesystem::copy_options::recursive
          | std::filesystem::copy_options::overwrite_existing
        );
    }
    const Outcome again = where.succeed("granularFoamSPH");
    EXPECT_TRUE(says(again, "Starting time loop"));
    expectSame(stateOf(where, "0.02"), state);
}
