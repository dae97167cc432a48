// Cases may lie anywhere: blanks, quotes, letters of any language.
#include "applications/AppCase.H"

using namespace sph;

namespace
{

const wordList names
{
    "-case with a blank",
    "S\xC3\xA4ule \xE6\xB2\x99\xE5\xB1\xB1: it's 50% \"$HOME\" #1;"
    " (a&b) [c] {d}"
};

} // namespace

TEST(oddPaths, applicationsAndRunFunctions)
{
    namespace fs = std::filesystem;
    for (const word& name : names)
    {
        const AppCase where;
        const fs::path odd = where.dir()/name;
        fs::create_directories(odd);
        for (const char* item : {"constant", "system", "Allrun", "Allclean"})
        {
            fs::rename(where.dir()/item, odd/item);
        }
        where.write
        (
            "script",
            "export SPH_PROJECT_DIR='" SPH_PROJECT_ROOT "' OMP_NUM_THREADS=1\n"
            "PATH='" SPH_BIN_DIR "':$PATH\n"
            "cd -- \"$1\" && ./Allrun && here=$PWD && cd / &&\n"
            "granularFoamSPH -case \"$here\" -postProcess -latestTime\n"
        );
        std::string quoted = "'";
        for (const char c : odd.string())
        {
            quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
        }
        const Outcome outcome = shell
        (
            "sh '" + (where.dir()/"script").string() + "' " + quoted + "'"
        );
        EXPECT_EQ(outcome.code, 0) << name << '\n' << outcome.text;
        EXPECT_TRUE(says(outcome, "run-out (Lf-L0)/L0"));
        EXPECT_FALSE(contains(outcome.text, "Warning")) << outcome.text;
        const std::string VTK = name + "/VTK/" + name + ".vtp.series";
        EXPECT_TRUE(where.has(VTK));
        for
        (
            const char* file :
            {
                "0.02/granular.vtp", "0.02/walls.vtp", "effective/0",
                "postProcessing/postRunout/0/summary.dat",
                "postProcessing/runout/0/runout.dat"
            }
        )
        {
            EXPECT_TRUE(where.has(name + '/' + file)) << name << ' ' << file;
        }
        if (shell("command -v gnuplot").code == 0)
        {
            EXPECT_TRUE
            (
                where.has(name + "/postProcessing/postRunout/0/collapse.png")
            );
        }
    }
}
