// Time folders of which a part is missing: named with what to do, or passed
// over where nothing says that they were ever whole.
#include "applications/StateFiles.H"

using namespace sph;

namespace
{

// A case with the times 0, 0.01 and 0.02, to go on to 0.03
struct cutShort : testing::Test
{
    AppCase where;

    cutShort()
    {
        where.succeed("setParticles");
        where.succeed("granularFoamSPH");
        where.set("system/controlDict", "endTime", "0.03");
    }

    std::string expectRefused(const std::string& file) const
    {
        const Outcome outcome = where.run("granularFoamSPH");
        EXPECT_EQ(outcome.code, 1) << outcome.text;
        EXPECT_TRUE(says(outcome, "--> FOAM FATAL IO ERROR:"));
        EXPECT_TRUE(says(outcome, "file: " + (where.dir()/file).string()));
        EXPECT_FALSE(where.has("0.03"));
        return outcome.text;
    }
};

} // namespace

TEST_F(cutShort, fileOfParticles)
{
    for (const word file : {"0.02/granular.vtp", "0.02/walls.vtp"})
    {
        const std::string whole = where.text(file);
        for (const std::size_t part : {0, 1, 3, 7})
        {
            where.write(file, whole.substr(0, whole.size()*part/8));
            EXPECT_CONTAINS(expectRefused(file), "Remove this time folder");
        }
        // A block of the disk short
        where.write(file, whole.substr(0, whole.size() - 512));
        EXPECT_CONTAINS(expectRefused(file), "The file is broken");
        where.write(file, whole);
    }

    // Without it the folder counts as not written, and the run goes on from
    // the one before
    const auto state = stateOf(where, "0.02");
    where.remove("0.02/granular.vtp");
    EXPECT_TRUE(says(where.succeed("granularFoamSPH"), "starting from 0.01"));
    expectSame(stateOf(where, "0.02"), state);
}

TEST_F(cutShort, fileOfWallsMissing)
{
    where.remove("0.02/walls.vtp");
    const Outcome outcome = where.run("granularFoamSPH");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_TRUE(says(outcome, "its walls.vtp is missing"));
    EXPECT_TRUE(says(outcome, "Remove this time folder"));
}

TEST_F(cutShort, uniformFiles)
{
    where.replace
    (
        "constant/granularProperties", "\n +KFactor [^;]*;",
        "\nadaptive yes; KFactor 100;"
    );
    where.remove("0.01");
    where.remove("0.02");
    where.set("system/controlDict", "endTime", "0.02");
    where.succeed("granularFoamSPH");
    where.set("system/controlDict", "endTime", "0.03");

    for (const word name : {"time", "equationOfState"})
    {
        const word file = "0.02/uniform/" + name;
        // After any ';' the rest may be missing unseen by the grammar
        const std::string whole = where.text(file);
        std::size_t cuts = 0;
        for
        (
            std::size_t end = whole.find(';', whole.find("}"));
            end + 2 < whole.size();
            end = whole.find(';', end + 1)
        )
        {
            where.write(file, whole.substr(0, end + 1) + '\n');
            EXPECT_CONTAINS(expectRefused(file), "not found");
            where.write(file, whole.substr(0, end));
            EXPECT_CONTAINS(expectRefused(file), "not ended by ';'");
            ++cuts;
        }
        EXPECT_GE(cuts, 2u);
        where.write(file, "");
        EXPECT_CONTAINS(expectRefused(file), "not found");
        where.write(file, whole);
    }
    where.succeed("granularFoamSPH");
}

TEST_F(cutShort, uniformFilesMissing)
{
    // A start from these particles, which may be what is wanted
    where.remove("0.02/uniform/time");
    const Outcome anew = where.succeed("granularFoamSPH");
    EXPECT_TRUE(says(anew, "There is no 0.02/uniform/time"));
    EXPECT_TRUE(where.has("0.03/granular.vtp"));

    // The bulk modulus cannot be guessed
    where.replace
    (
        "constant/granularProperties", "\n +KFactor [^;]*;",
        "\nadaptive yes; KFactor 100;"
    );
    where.remove("0.03/uniform/equationOfState");
    where.set("system/controlDict", "endTime", "0.04");
    const Outcome unknown = where.run("granularFoamSPH");
    EXPECT_EQ(unknown.code, 1);
    EXPECT_TRUE(says(unknown, "0.03/uniform/equationOfState"));
    EXPECT_TRUE(says(unknown, "Remove this time folder"));
}
