#include "AppCase.H"

namespace sph
{

namespace
{

// Runs that are read in place of those of etc/charts
const char* const measured = R"(
columnA1
{
    kind column;  aspect 1;  duration 10;  reference "a finer run";
    runs
    (
        { setting fast; across 10; particles 100; time 1; error 4;
          front 6; height 1; }
        { setting fast; across 20; particles 400; time 8; error 2;
          front 3; height 0.5; }
        { setting accurate; across 20; particles 400; time 20; error 1;
          front 1; height 0.5; }
    );
}
)";

Outcome advised(const AppCase& where, const std::string& percent)
{
    where.write("etc/charts/measured", measured);
    where.write("etc/caseDicts/fast/controlDict", "maxCo 0.8;");
    return where.run
    (
        "granularFoamSPH -advise " + percent, 1,
        "export SPH_ETC='" + (where.dir()/"etc").string() + '\''
    );
}

} // namespace

// No particles are there, none are made
TEST(advise, namesTheCheapestRunWithinTheError)
{
    const AppCase where;
    const Outcome three = advised(where, "3");
    EXPECT_EQ(three.code, 0) << three.text;
    EXPECT_TRUE(says(three, "Nearest scene that was measured: columnA1"));
    EXPECT_TRUE(says(three, "reached by fast with\n20 particles across"));
    EXPECT_TRUE(says(three, "#includeEtc \"caseDicts/fast/controlDict\""));
    EXPECT_FALSE(says(three, "caseDicts/fast/sphSchemes"));
    EXPECT_TRUE(says(three, "coarse: 9 particles across"));
    EXPECT_TRUE(says(advised(where, "1.5"), "accurate with\n20"));
    EXPECT_TRUE(says(advised(where, "0.1"), "No measured run comes within"));
    EXPECT_FALSE(where.has("0"));
}

TEST(advise, saysWhereNothingLikeItWasMeasured)
{
    const AppCase where;
    where.append
    (
        "constant/granularProperties",
        "rheology Newtonian; NewtonianCoeffs { eta 1; }"
    );
    EXPECT_TRUE(says(advised(where, "5"), "Nothing like it was measured"));
}

// What comes with the code: the settings that it names can be taken as it says
TEST(advise, itsSettingsAreThere)
{
    for (const std::string setting : {"fast", "balanced", "accurate", "impact"})
    {
        const AppCase where;
        label taken = 0;
        for
        (
            const std::string file :
            {
                "constant/granularProperties", "system/controlDict",
                "system/sphSchemes"
            }
        )
        {
            const auto name = "caseDicts/" + setting + '/'
              + std::filesystem::path(file).filename().string();
            if (std::filesystem::exists(SPH_PROJECT_ROOT "/etc/" + name))
            {
                where.append(file, "#includeEtc \"" + name + '"');
                ++taken;
            }
        }
        EXPECT_GT(taken, 0) << setting;
        where.succeed("setParticles");
        where.succeed("granularFoamSPH -dry-run");
    }
    const AppCase where;
    EXPECT_TRUE
    (
        says(where.succeed("granularFoamSPH -advise 10"), "columnA0.9")
    );
}

TEST(advise, refusesWhatIsNoError)
{
    const AppCase where;
    for (const char* percent : {"0", "-3", "x", "5%", "nan"})
    {
        const Outcome outcome = advised(where, percent);
        EXPECT_EQ(outcome.code, 1) << percent;
        EXPECT_TRUE(says(outcome, "-advise takes the wanted error in percent"));
    }
    const Outcome both = advised(AppCase(), "5 -dry-run");
    EXPECT_EQ(both.code, 1);
    EXPECT_TRUE(says(both, "leave out -dry-run"));
}

} // namespace sph
