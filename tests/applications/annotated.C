// etc/caseDicts/annotated: as the code has it, complete, and fit to be used.
#include "applications/AppCase.H"
#include "selection/Selectable.H"

#include <set>

using namespace sph;
namespace fs = std::filesystem;

namespace
{

const fs::path annotated =
    fs::path(SPH_PROJECT_ROOT)/"etc"/"caseDicts"/"annotated";

std::string textOf(const fs::path& file)
{
    std::ifstream is(file);
    return {std::istreambuf_iterator<char>(is), {}};
}

std::string include(const std::string& name)
{
    return "#includeEtc \"caseDicts/annotated/" + name + "\"\n";
}

// The dictionary of that name at the top of an annotated file
std::string block(const std::string& file, const std::string& name)
{
    const std::string text = textOf(annotated/file);
    const auto begin = text.find('\n' + name + "\n{\n");
    EXPECT_NE(begin, std::string::npos) << name << " in " << file;
    return text.substr(begin, text.find("\n}\n", begin) + 3 - begin);
}

// The nth model of a family, and its first one when they are over
std::string choice(const std::string& family, const std::size_t n)
{
    const auto& models = SelectionTables::all()[family];
    auto model = models.begin();
    std::advance(model, n < models.size() ? n : 0);
    return include(family) + family + ' ' + model->first + ";\n";
}

// The names that an application lists where an entry is not used
std::set<std::string> askedFor
(
    const AppCase& where, const std::string& command, const std::string& file
)
{
    const std::string before = where.text(file);
    where.append(file, "zzzzzzzzzzzzzzzz 1;");
    const std::string said = where.run(command).text;
    where.write(file, before);
    const auto begin = said.find("Valid entries are");
    EXPECT_NE(begin, std::string::npos) << command << '\n' << said;
    std::istringstream is(said.substr(said.find("(\n", begin) + 2));
    std::set<std::string> names;
    for (std::string name; is >> name && name != ")"; )
    {
        names.insert(name);
    }
    return names;
}

} // namespace

TEST(annotated, isWhatTheApplicationsWriteToday)
{
    const TestCase where;
    const Outcome outcome = shell
    (
        "'" SPH_PROJECT_ROOT "/etc/caseDicts/annotate' '"
      + where.dir().string() + "/now'"
    );
    ASSERT_EQ(outcome.code, 0) << outcome.text;
    std::set<std::string> names;
    for (const fs::path& folder : {annotated, where.dir()/"now"})
    {
        for (const auto& entry : fs::directory_iterator(folder))
        {
            names.insert(entry.path().filename().string());
        }
    }
    EXPECT_GT(names.size(), 20u);
    for (const std::string& name : names)
    {
        EXPECT_EQ(textOf(annotated/name), textOf(where.dir()/"now"/name))
            << name << ": run etc/caseDicts/annotate";
    }
}

TEST(annotated, everyEntryStandsAfterItsMeaning)
{
    for (const auto& entry : fs::directory_iterator(annotated))
    {
        std::smatch bare;
        const std::string text = textOf(entry.path());
        EXPECT_FALSE
        (
            std::regex_search
            (
                text, bare, std::regex("\n\n *[A-Za-z0-9]+ +[^\n]*;")
            )
        ) << entry.path() << bare.str();
    }
}

TEST(annotated, everyModelRunsAsItStandsThere)
{
    const AppCase where;
    where.write
    (
        "system/controlDict",
        include("controlDict") + "endTime 0.01; writeInterval 10;\n"
    );
    const auto run = [&](const std::string& rheology, const std::size_t n)
    {
        where.write
        (
            "constant/granularProperties",
            include("granularProperties") + choice("equationOfState", n)
          + include("rheology") + "rheology " + rheology + ";\n"
          + choice("turbulence", n) + choice("sideWalls", n)
        );
        // The others of these take a fluid only
        const bool fluid = 
            rheology != "DruckerPrager" && rheology.find("elasto") != 0;
        where.write
        (
            "system/sphSchemes",
            include("sphSchemes") + choice("kernel", n)
          + choice("correction", n + 1) + choice("shifting", n)
          + choice("artificialViscosity", n) + choice("stabilisation", n)
          + (fluid ? choice("viscousScheme", n) : "")
        );
        where.write
        (
            "system/sphSolution",
            include("sphSolution") + choice("integrator", n)
        );
        where.succeed("setParticles");
        where.succeed("granularFoamSPH -dry-run");
    };
    for (std::size_t n = 0; n < 6; ++n)
    {
        run(n % 2 == 0 ? "Newtonian" : "muI", n);
    }
    for (const auto& rheology : SelectionTables::all()["rheology"])
    {
        run(rheology.first, 0);
    }
    for (const char* family : {"functionObject", "rheology"})
    {
        EXPECT_GT(SelectionTables::all().at(family).size(), 6u);
    }
    for (const auto& [family, models] : SelectionTables::all())
    {
        if (family != "functionObject" && family != "rheology")
        {
            EXPECT_LE(models.size(), 6u) << family;
        }
    }
}

TEST(annotated, everyFunctionObjectRunsAsItStandsThere)
{
    const AppCase where;
    where.succeed("setParticles");
    std::string blocks;
    for (const auto& [type, is] : SelectionTables::all()["functionObject"])
    {
        blocks += block("functionObject", type);
    }
    where.replace
    (
        "system/controlDict", "functions[\\s\\S]*",
        "functions\n{" + blocks + "}\n"
    );
    where.succeed("granularFoamSPH -dry-run");
    const Outcome outcome = where.succeed("granularFoamSPH");
    EXPECT_TRUE(says(outcome, "\nEnd\n"));
    for (const char* type : {"forces", "probes", "sets", "profile"})
    {
        EXPECT_TRUE(where.has("postProcessing/" + std::string(type))) << type;
    }
}

TEST(annotated, everyPatchRunsAsItStandsThere)
{
    const AppCase where;
    const std::string plane = block("boundary", "symmetryPlane");
    for (const char* wall : {"noSlip", "freeSlip", "Morris"})
    {
        where.write("constant/boundary", block("boundary", wall) + plane);
        where.succeed("setParticles");
        where.succeed("granularFoamSPH -dry-run");
    }
    where.write
    (
        "constant/boundary",
        block("boundary", "noSlip") + block("boundary", "periodic")
    );
    where.succeed("setParticles");
    where.succeed("granularFoamSPH -dry-run");
}

TEST(annotated, everyRegionIsFilledAsItStandsThere)
{
    const AppCase where;
    where.write("constant/boundary", "");
    for (const auto& [type, is] : SelectionTables::all()["region"])
    {
        where.write
        (
            "system/setParticlesDict",
            include("setParticlesDict") + "regions\n(\n"
          + block("region", type) + ");\n"
        );
        where.succeed("setParticles");
    }
}

TEST(annotated, everyLawIsReadAsItStandsThere)
{
    const AppCase where;
    where.succeed("setParticles");
    for (const auto& [law, is] : SelectionTables::all()["runoutLaw"])
    {
        where.write
        (
            "system/postRunoutDict",
            include("postRunoutDict") + include("runoutLaw")
          + "law " + law + ";\n"
        );
        EXPECT_TRUE(says(where.succeed("postRunout"), "law: " + law));
    }
}

TEST(annotated, holdsAllThatTheApplicationsAskFor)
{
    const AppCase where;
    where.write("system/rheologyMapDict", "p (1 2); gammaDot (1 2);");
    where.succeed("setParticles");
    const std::vector<std::pair<std::string, std::string>> read
    {
        {"system/setParticlesDict", "setParticles"},
        {"constant/granularProperties", "granularFoamSPH -dry-run"},
        {"constant/g", "granularFoamSPH -dry-run"},
        {"system/controlDict", "granularFoamSPH -dry-run"},
        {"system/sphSchemes", "granularFoamSPH -dry-run"},
        {"system/sphSolution", "granularFoamSPH -dry-run"},
        {"system/postRunoutDict", "postRunout"},
        {"system/rheologyMapDict", "rheologyMap"}
    };
    std::string text;
    for (const auto& entry : fs::directory_iterator(annotated))
    {
        text += textOf(entry.path());
    }
    for (const auto& [file, command] : read)
    {
        for (const std::string& name : askedFor(where, command, file))
        {
            const bool ofModel = contains(name, "Coeffs");
            EXPECT_TRUE
            (
                ofModel
             || std::regex_search
                (
                    text, std::regex("\n[/ ]*" + name + "[ \n]")
                )
            ) << name << " in " << file;
        }
    }
}
