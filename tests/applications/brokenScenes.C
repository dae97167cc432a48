// Particles, walls and folders that cannot be worked with: each is answered by
// a message that says what is wrong and where, and by exit code 1.
#include "applications/expectFailure.H"

using namespace sph;

static const std::string setup = "system/setParticlesDict";

TEST(brokenScenes, startTimeWithoutParticles)
{
    const AppCase broken;
    const Outcome outcome = broken.run("granularFoamSPH");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_TRUE(says(outcome, "There is no time folder"));
    EXPECT_TRUE(says(outcome, "Run setParticles first"));
}

TEST(brokenScenes, zeroSpacing)
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

TEST(brokenScenes, overlappingRegions)
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
TEST(brokenScenes, unwritableFolder)
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

TEST(brokenScenes, emptyColumn)
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

TEST(brokenScenes, particlesOutsideOfAPeriodicPatch)
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

TEST(brokenScenes, boundaryChangedAfterSetParticles)
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

// New particles, and the times of an earlier run beside them
TEST(brokenScenes, laterTimesOfAnEarlierRun)
{
    const AppCase where;
    EXPECT_FALSE(says(where.succeed("setParticles"), "Warning"));
    where.succeed("granularFoamSPH");
    const Outcome outcome = where.succeed("setParticles");
    EXPECT_TRUE(says(outcome, "Times of an earlier run are there: 0.01 0.02"));
    EXPECT_TRUE(says(outcome, "startFrom latestTime"));
}
