// What bash offers after a command has been begun: etc/completion.
#include "applications/AppCase.H"

using namespace sph;

namespace
{

struct Shell : AppCase
{
    // The words offered for the last of each of these commands, one a line
    // after an empty one; in the folder above the case
    wordList offered(const wordList& commands) const
    {
        std::string script =
            "cd '" + dir().parent_path().string() + "'\n"
            ". " SPH_PROJECT_ROOT "/etc/bashrc > /dev/null\n"
            "PATH='" SPH_BIN_DIR "':$PATH\n";
        for (const std::string& command : commands)
        {
            script +=
                "COMP_WORDS=(" + command + ")\n"
                "COMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n"
                "_sphComplete \"${COMP_WORDS[0]}\"\n"
                "printf '\\n%s' \"${COMPREPLY[@]}\"; printf '\\n\\f'\n";
        }
        write("complete", script);
        const Outcome outcome = shell
        (
            "bash '" + (dir()/"complete").string() + "'"
        );
        EXPECT_EQ(outcome.code, 0) << outcome.text;
        wordList answers;
        std::istringstream is(outcome.text);
        for (std::string answer; std::getline(is, answer, '\f'); )
        {
            answers.push_back(answer);
        }
        EXPECT_EQ(answers.size(), commands.size()) << outcome.text;
        answers.resize(commands.size());
        return answers;
    }

    // The case from there
    std::string name() const { return dir().filename().string(); }
};

// The options that an application's -help names
wordList optionsOf(const std::string& command)
{
    wordList options;
    std::istringstream is(shell(command + " -help").text);
    for (std::string line; std::getline(is, line); )
    {
        if (line.compare(0, 3, "  -") == 0)
        {
            options.push_back(line.substr(2, line.find_first_of(" ,", 2) - 2));
        }
    }
    return options;
}

} // namespace

TEST(completion, offersAllOptionsOfAllApplications)
{
    const Shell where;
    std::map<std::string, std::string> programs
    {
        {"foamLog", SPH_PROJECT_ROOT "/etc/bin/foamLog"}
    };
    if (shell("command -v python3").code == 0)
    {
        programs["paraSPH"] = SPH_PROJECT_ROOT "/etc/paraview/paraSPH";
    }
    using Folder = std::filesystem::directory_iterator;
    for (const auto& entry : Folder(SPH_PROJECT_ROOT "/applications"))
    {
        if (entry.is_directory())
        {
            const std::string name = entry.path().filename().string();
            programs[name] = SPH_BIN_DIR "/" + name;
        }
    }
    const std::string completion = shell
    (
        "cat " SPH_PROJECT_ROOT "/etc/completion"
    ).text;
    const std::string commands =
        completion.substr(completion.rfind("complete -F"));
    wordList begun{"setParticles -lat", "postRunout -lat"};
    for (const auto& [name, file] : programs)
    {
        begun.push_back(name + " -");
    }
    const wordList offered = where.offered(begun);
    EXPECT_EQ(offered[0], "\n\n");
    EXPECT_EQ(offered[1], "\n-latestTime\n");
    auto answer = offered.begin() + 2;
    for (const auto& [name, file] : programs)
    {
        const wordList options = optionsOf(file);
        EXPECT_GT(options.size(), 1u) << name;
        for (const word& option : options)
        {
            EXPECT_CONTAINS(*answer, '\n' + option + '\n');
        }
        EXPECT_CONTAINS(commands, ' ' + name);
        ++answer;
    }
}

TEST(completion, offersCasesTimesFieldsAndFunctionObjects)
{
    const Shell where;
    where.succeed("setParticles");
    for (const char* folder : {"0.25", "10", "9", "0.orig"})
    {
        where.mkdir(folder);
    }
    const std::string name = where.name();
    const std::string inCase = " -case " + name + ' ';
    const wordList offered = where.offered
    ({
        "postRunout -case " + name.substr(0, name.size() - 1),
        "postRunout" + inCase + "-time ''",
        "paraSPH" + inCase + "-time 0 : 0.2",
        "paraSPH" + inCase + "-time 0.25,1",
        "paraSPH" + inCase + "-field ''",
        "granularFoamSPH" + inCase + "-postProcess -func ''",
        "granularFoamSPH" + inCase + "-listEntries elastoViscoplasticM"
    });
    EXPECT_EQ(offered[0], '\n' + name + '\n');
    EXPECT_EQ(offered[1], "\n0\n0.25\n9\n10\n");
    EXPECT_EQ(offered[2], "\n0.25\n");
    EXPECT_EQ(offered[3], "\n0.25,10\n");
    EXPECT_CONTAINS(offered[4], "\np\n");
    EXPECT_CONTAINS(offered[4], "\nU\n");
    EXPECT_FALSE(contains(offered[4], "Points"));
    EXPECT_CONTAINS(offered[5], "\nstopWhenAtRest\n");
    EXPECT_CONTAINS(offered[5], "\nfieldMinMax\n");
    EXPECT_EQ(offered[6], "\nelastoViscoplasticMuI\n");
}

// An unknown value must not make an application do its work
TEST(completion, writesNothing)
{
    const Shell where;
    where.succeed("setParticles");
    const std::string name = where.name();
    wordList begun;
    for (const char* option : {"-times", "-dict", "-field", "-funcs"})
    {
        begun.push_back("postRunout -case " + name + ' ' + option + " zzz");
    }
    where.offered(begun);
    EXPECT_FALSE(where.has("postProcessing"));
}
