// The numbers that etc/bin/foamLog takes out of real logs.
#include "applications/AppCase.H"

using namespace sph;

namespace
{

const std::string foamLog = SPH_PROJECT_ROOT "/etc/bin/foamLog";

// A case with log.granularFoamSPH
struct Logged : AppCase
{
    Logged(const std::function<void(const AppCase&)>& change)
    {
        change(*this);
        succeed("setParticles");
        succeed("granularFoamSPH > log.granularFoamSPH");
    }

    Outcome extract(const std::string& options = "") const
    {
        return shell
        (
            "cd '" + dir().string() + "' && HOME=/ '" + foamLog + "' "
          + options + " log.granularFoamSPH"
        );
    }

    // The numbers after text in the lines of the log that begin with it
    wordList after(const std::string& begin, const std::string& text) const
    {
        wordList values;
        std::istringstream is(this->text("log.granularFoamSPH"));
        for (std::string line; std::getline(is, line); )
        {
            if (line.compare(0, begin.size(), begin) == 0)
            {
                std::istringstream rest
                (
                    line.substr(line.find(text) + text.size())
                );
                word value;
                rest >> value;
                values.push_back(value.substr(0, value.find(',')));
            }
        }
        return values;
    }

    wordList column(const std::string& name, const label column) const
    {
        wordList values;
        std::istringstream is(text("logs/" + name + "_0"));
        for (std::string line; std::getline(is, line); )
        {
            std::istringstream words(line);
            word value;
            for (label k = 0; k <= column; ++k)
            {
                words >> value;
            }
            values.push_back(value);
        }
        return values;
    }
};

} // namespace

TEST(foamLog, findsWhatEveryStepSays)
{
    const Logged where([](const AppCase&) {});
    const Outcome outcome = where.extract();
    EXPECT_EQ(outcome.code, 0);
    EXPECT_TRUE(says(outcome, "Generated files for:\nCourantMax\nCourantMean"));
    const wordList times = where.after("Time = ", "Time = ");
    EXPECT_GT(times.size(), 10u);
    const std::vector<std::array<std::string, 3>> quantities
    {
        {"Time", "Time = ", "Time = "},
        {"deltaT", "deltaT = ", "deltaT = "},
        {"CourantMean", "Courant Number", "mean: "},
        {"CourantMax", "Courant Number", "max: "},
        {"pairListsRebuilt", "Pair lists", "rebuilt: "},
        {"wallNetHits", "Pair lists", "hits: "},
        {"executionTime", "ExecutionTime", "ExecutionTime = "},
        {"clockTime", "ExecutionTime", "ClockTime = "}
    };
    for (const auto& [name, begin, text] : quantities)
    {
        EXPECT_EQ(where.column(name, 0), times) << name;
        EXPECT_EQ(where.column(name, 1), where.after(begin, text)) << name;
    }
    EXPECT_FALSE(where.has("logs/soundSpeed_0"));
}

TEST(foamLog, findsSolverSoundSpeedAndSleepers)
{
    const Logged implicit([](const AppCase& where)
    {
        where.set("system/sphSchemes", "viscousScheme", "Morris");
        where.set("constant/granularProperties", "rheology", "Newtonian");
        where.append
        (
            "constant/granularProperties", "NewtonianCoeffs { eta 10; }"
        );
        where.append("system/sphSolution", "viscousIntegration implicit;");
    });
    EXPECT_EQ(implicit.extract().code, 0);
    EXPECT_EQ
    (
        implicit.column("UIters", 1), implicit.after("PCG:", "Iterations ")
    );
    EXPECT_EQ
    (
        implicit.column("U", 1), implicit.after("PCG:", "Initial residual = ")
    );
    EXPECT_EQ(implicit.column("UFinalRes", 0), implicit.column("Time", 0));

    const Logged sleeping([](const AppCase& where)
    {
        where.append("system/sphSolution", "sleep {}");
        where.append
        (
            "constant/granularProperties", "linearCoeffs { H 0.01; adaptive yes; }"
        );
    });
    EXPECT_EQ(sleeping.extract().code, 0);
    EXPECT_EQ
    (
        sleeping.column("sleepers", 1), sleeping.after("Asleep: ", "Asleep: ")
    );
    EXPECT_EQ(sleeping.column("sleepers", 0), wordList({"0.01", "0.02"}));
    // Both before the first step
    const wordList speeds = sleeping.after("Sound speed", "-> ");
    ASSERT_EQ(speeds.size(), 2u);
    EXPECT_EQ(sleeping.column("soundSpeed", 1), wordList({speeds[0]}));
    EXPECT_CONTAINS(sleeping.text("logs/soundSpeed_1"), '\t' + speeds[1]);
}

TEST(foamLog, keepsToItsOptions)
{
    const Logged where([](const AppCase&) {});
    const Outcome list = where.extract("-list");
    EXPECT_EQ(list.code, 0);
    EXPECT_TRUE(says(list, "wallNetHits\n"));
    EXPECT_FALSE(where.has("logs"));

    where.mkdir("elsewhere");
    where.write("foamLog.db", "step/^Time = /Time = \nTime/^Time = /Time = ");
    const Outcome own = where.extract("-n -quiet -localDB -case elsewhere");
    EXPECT_EQ(own.text, "Time\nstep\n");
    EXPECT_EQ
    (
        where.text("elsewhere/logs/step_0"),
        where.text("elsewhere/logs/Time_0")
    );
    EXPECT_FALSE(contains(where.text("elsewhere/logs/step_0"), "\t"));

    EXPECT_EQ(where.extract("-lst").code, 1);
    EXPECT_TRUE(says(where.extract("-lst"), "Unknown option -lst"));
    const Outcome none = shell("'" + foamLog + "' /nowhere/log");
    EXPECT_EQ(none.code, 1);
    EXPECT_TRUE(says(none, "Cannot read the log /nowhere/log"));
}
