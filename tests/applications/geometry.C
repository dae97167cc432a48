// A wall and a column from files, run as a user does.
#include "applications/StateFiles.H"
#include "applications/expectFailure.H"

using namespace sph;

namespace
{

const std::string bedFile = "geometry { file \"constant/geometry/bed.csv\"; }";
const std::string columnFile =
    "geometry { file \"constant/geometry/column.csv\"; }";

// The tutorial with its bed and its column drawn by files
AppCase drawn()
{
    AppCase where;
    where.write("constant/geometry/bed.csv", "x,y\n0,0\n0.35,0\n");
    where.write
    (
        "constant/geometry/column.csv",
        "0,0\n0.0972,0\n0.0972,0.08748\n0,0.08748\n"
    );
    where.replace("constant/boundary", "points[^;]*;", bedFile);
    where.replace
    (
        "system/setParticlesDict", "type\\s*box;[^}]*\\}",
        "type polygon; " + columnFile + " }"
    );
    where.replace("system/setParticlesDict", "\nh0[^;]*;", "");
    return where;
}

} // namespace


TEST(geometry, ofFilesRunsToTheSameBitsAsTyped)
{
    const AppCase typed;
    typed.succeed("setParticles");
    typed.succeed("granularFoamSPH");
    const AppCase files = drawn();
    const Outcome setup = files.succeed("setParticles");
    EXPECT_TRUE
    (
        says(setup, "Reading bed.csv: 2 points from (0 0 0) to (0.35 0 0)")
    );
    files.succeed("granularFoamSPH");
    const auto state = stateOf(files, "0.02");
    expectSame(state, stateOf(typed, "0.02"));

    // And with what took effect in place of what was written
    files.remove("0.02");
    files.remove("0.01");
    for (const word& folder : wordList{"constant", "system"})
    {
        std::filesystem::copy
        (
            files.dir()/"effective"/"0"/folder, files.dir()/folder,
            std::filesystem::copy_options::recursive
          | std::filesystem::copy_options::overwrite_existing
        );
    }
    EXPECT_TRUE(contains(files.text("constant/boundary"), "shortest"));
    files.succeed("granularFoamSPH");
    expectSame(stateOf(files, "0.02"), state);
}

TEST(geometry, thatIsWrongEndsBothPrograms)
{
    const AppCase broken = drawn();
    broken.succeed("setParticles");
    broken.write("constant/geometry/bed.csv", "x,y\n0,0\n0.35,a\n");
    for (const char* program : {"setParticles", "granularFoamSPH"})
    {
        const Outcome outcome = broken.run(program);
        EXPECT_EQ(outcome.code, 1);
        EXPECT_TRUE(says(outcome, "--> FOAM FATAL IO ERROR:"));
        EXPECT_TRUE(says(outcome, "column y, found 'a'"));
        EXPECT_TRUE(says(outcome, "bed.csv at line 3."));
    }
    // Another wall than that of the particles
    broken.write("constant/geometry/bed.csv", "x,y\n0,0\n0.4,0\n");
    const Outcome moved = broken.run("granularFoamSPH");
    EXPECT_EQ(moved.code, 1);
    EXPECT_TRUE(says(moved, "Run setParticles again"));
}
