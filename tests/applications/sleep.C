// Particles that sleep, in a case: what is written and said, and restarts.
#include "applications/AppCase.H"
#include "io/caseIO.H"

#include <sstream>

using namespace sph;

namespace
{

// The collapse of 360 particles, most of which sleep in the end
struct Collapse : AppCase
{
    explicit Collapse(const word& endTime, const bool sleep = true)
    {
        set("system/setParticlesDict", "nr", "20");
        set("system/controlDict", "writeInterval", "0.09");
        set("system/controlDict", "endTime", endTime);
        if (sleep)
        {
            append("system/sphSolution", "sleep {}");
        }
        succeed("setParticles");
    }

    label asleep(const word& time) const
    {
        Particles particles;
        readState(dir()/time, particles);
        const scalar* flags = particles.asleep.data();
        return label
        (
            std::count(flags, flags + particles.granular().end, 1)
        );
    }

    scalar largestSpeed(const word& time) const
    {
        Particles particles;
        readState(dir()/time, particles);
        scalar largest = 0;
        for (label i = 0; i < particles.granular().end; ++i)
        {
            largest = std::max(largest, particles.U[i].norm());
        }
        return largest;
    }

    bool writes(const word& time, const word& field) const
    {
        return contains(text(time + "/granular.vtp"), '"' + field + '"');
    }
};

} // namespace

TEST(sleep, theLogTellsWhatItDoes)
{
    const Collapse where("0.27");
    const Outcome outcome = where.succeed("granularFoamSPH");
    EXPECT_TRUE
    (
        std::regex_search
        (
            outcome.text,
            std::regex
            (
                "\nSelecting sleep speed \\S+ m/s mean \\S+ m/s"
                " rest \\S+ m/s\n"
            )
        )
    );
    EXPECT_TRUE
    (
        std::regex_search
        (
            outcome.text,
            std::regex
            (
                "\nParticle-steps made: \\S+ %\n"
                "Taken by sleep: momentum \\(\\S+ \\S+\\) kg/s,"
                " energy \\S+ J/m\n\nEnd\n"
            )
        )
    );
    // One line for each time that is written
    std::istringstream log(outcome.text);
    wordList lines;
    for (std::string line; std::getline(log, line); )
    {
        if (contains(line, "sleep"))
        {
            EXPECT_LE(line.size(), 80u) << line;
        }
        if (line.rfind("Asleep: ", 0) == 0)
        {
            lines.push_back(line);
        }
    }
    ASSERT_EQ(lines.size(), 3u);
    EXPECT_EQ
    (
        lines.back(),
        "Asleep: " + std::to_string(where.asleep("0.27")) + " of 360 particles"
    );
    EXPECT_GT(where.asleep("0.27"), 20);
}

TEST(sleep, isDecidedHoweverOftenTheStateIsWritten)
{
    const Collapse where("0.2");
    where.set("system/controlDict", "writeControl", "timeStep");
    where.set("system/controlDict", "writeInterval", "3");
    where.append("system/controlDict", "purgeWrite 2;");
    where.succeed("granularFoamSPH");
    EXPECT_GT(where.asleep(where.latestTime()), 20);
}

// Nothing hangs in the air that gravity holds no longer
TEST(sleep, otherGravityWakesTheHeap)
{
    const Collapse where("0.27");
    where.succeed("granularFoamSPH");
    ASSERT_GT(where.asleep("0.27"), 20);

    where.replace("constant/g", "0 -9.81 0", "9.81 0 0");
    where.set("system/controlDict", "endTime", "0.36");
    const Outcome outcome = where.succeed("granularFoamSPH");
    EXPECT_TRUE
    (
        says
        (
            outcome,
            "\nAll particles are awake: constant/g has changed since time"
            " 0.27\n"
        )
    );
    EXPECT_EQ(where.asleep("0.36"), 0);
    EXPECT_GT(where.largestSpeed("0.36"), 0.5);
}

TEST(sleep, leavesNoTraceWhereItIsNotAsked)
{
    const Collapse where("0.09", false);
    const Outcome without = where.succeed("granularFoamSPH");
    for (const word time : {"0", "0.09"})
    {
        EXPECT_FALSE(where.writes(time, "asleep"));
        EXPECT_FALSE(where.writes(time, "Umean"));
        EXPECT_TRUE(where.writes(time, "U"));
        EXPECT_FALSE(where.has(time + "/uniform/sleep"));
    }
    EXPECT_FALSE(contains(without.text, "leep"));
    EXPECT_FALSE(contains(without.text, "article-steps"));

    // Switched on at a restart, which begins with all awake
    where.append("system/sphSolution", "sleep {}");
    where.set("system/controlDict", "endTime", "0.27");
    const Outcome with = where.succeed("granularFoamSPH");
    EXPECT_TRUE
    (
        says
        (
            with,
            "\nAll particles are awake: there is no 0.09/uniform/sleep\n"
        )
    );
    EXPECT_FALSE(contains(with.text, "\nTime = 0.08"));
    EXPECT_TRUE(where.writes("0.27", "asleep"));
    EXPECT_TRUE(where.writes("0.27", "Umean"));
    EXPECT_GT(where.asleep("0.27"), 20);

    // And off
    where.replace("system/sphSolution", "sleep \\{\\}", "");
    where.set("system/controlDict", "endTime", "0.36");
    const Outcome off = where.succeed("granularFoamSPH");
    EXPECT_TRUE
    (
        says
        (
            off,
            "\nAll particles are awake: no sleep in system/sphSolution\n"
        )
    );
    EXPECT_FALSE(contains(off.text, "\nTime = 0.26"));
    EXPECT_FALSE(where.writes("0.36", "asleep"));
    EXPECT_FALSE(where.has("0.36/uniform/sleep"));
}

TEST(sleep, mustBeADictionary)
{
    const AppCase where;
    where.append("system/sphSolution", "sleep yes;");
    where.succeed("setParticles");
    const Outcome outcome = where.run("granularFoamSPH");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_TRUE
    (
        says(outcome, "Entry 'sleep' must be a dictionary: sleep { }")
    );
    EXPECT_TRUE
    (
        says
        (
            outcome,
            "system/sphSolution at line "
          + std::to_string(where.line("system/sphSolution", "sleep yes"))
        )
    );
}
