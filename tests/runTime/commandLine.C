// Options with one dash, what is said about wrong ones, and the banner.
#include "runTime/TestCase.H"

#include "runTime/CommandLine.H"

namespace sph
{

namespace
{

CommandLine parse(std::vector<std::string> words)
{
    words.insert(words.begin(), "/usr/bin/granularFoamSPH");
    std::vector<char*> argv;
    for (std::string& text : words)
    {
        argv.push_back(text.data());
    }
    return CommandLine
    (
        int(argv.size()), argv.data(), "Flow of dry granular material",
        {
            {"listModels", "", "List all models"},
            {"time", "ranges", "Times to work on"},
            {"latestTime", "", "The latest time only"}
        }
    );
}

std::string errorOfOptions(const std::vector<std::string>& words)
{
    return errorOf([&]() { parse(words); });
}

} // namespace

TEST(commandLine, oneDashOrTwo)
{
    for (const std::string dash : {"-", "--"})
    {
        const CommandLine args = parse({dash + "listModels", dash + "time", "0.5"});
        EXPECT_TRUE(args.found("listModels"));
        EXPECT_FALSE(args.found("latestTime"));
        EXPECT_EQ(args.value("time"), "0.5");
        EXPECT_EQ(args.valueOr("time", "1"), "0.5");
        EXPECT_EQ(args.application(), "granularFoamSPH");
    }
    EXPECT_EQ(parse({}).valueOr("time", "1"), "1");
    EXPECT_EQ(parse({"-time=0.5"}).value("time"), "0.5");
    EXPECT_CONTAINS
    (
        errorOf([&]() { parse({}).value("time"); }), "-time"
    );
}

TEST(commandLine, unknownOptionListsTheValidOnesAndTheNearest)
{
    for (const char* option : {"-listModel", "--listModel"})
    {
        const std::string error = errorOfOptions({option});
        EXPECT_CONTAINS(error, "Unknown option " + std::string(option));
        EXPECT_CONTAINS(error, "did you mean '-listModels'?");
        for (const char* valid : {"-case", "-help-full", "-latestTime", "-time"})
        {
            EXPECT_CONTAINS(error, "\n" + std::string(valid) + "\n");
        }
    }
}

TEST(commandLine, abbreviationsAreNotGuessed)
{
    EXPECT_CONTAINS(errorOfOptions({"-list"}), "Unknown option -list");
    EXPECT_CONTAINS(errorOfOptions({"-latest"}), "Unknown option -latest");
}

TEST(commandLine, wrongArguments)
{
    EXPECT_CONTAINS(errorOfOptions({"-time"}), "-time needs an argument");
    EXPECT_CONTAINS
    (
        errorOfOptions({"-time", "1", "-time", "2"}), "-time is given twice"
    );
    EXPECT_CONTAINS
    (
        errorOfOptions({"-listModels=yes"}), "-listModels takes no argument"
    );
    EXPECT_CONTAINS(errorOfOptions({"myCase"}), "Unexpected argument myCase");
}

TEST(commandLine, caseIsAbsoluteAndChecked)
{
    const TestCase testCase;
    const std::string dir = testCase.dir().string();
    EXPECT_CONTAINS
    (
        errorOf([&]() { parse({"-case", dir}).caseDir(); }), "system"
    );
    EXPECT_CONTAINS
    (
        errorOf([&]() { parse({"-case", dir + "/away"}).caseDir(); }),
        "There is no case directory " + dir + "/away"
    );
    testCase.mkdir("system");
    EXPECT_EQ(parse({"-case", dir + "/"}).caseDir(), testCase.dir());
    EXPECT_EQ(parse({"-case", dir + "/system/.."}).caseDir(), testCase.dir());
}

TEST(commandLineDeathTest, helpPrintsTheUsageAndExitsWithZero)
{
    for (const char* option : {"-help", "--help", "-h", "-help-full"})
    {
        // Death tests match stderr only: send the usage there
        EXPECT_EXIT
        (
            {
                ::dup2(STDERR_FILENO, STDOUT_FILENO);
                parse({option});
            },
            testing::ExitedWithCode(0), "Usage: granularFoamSPH"
        ) << option;
    }
    EXPECT_EXIT
    (
        {
            ::dup2(STDERR_FILENO, STDOUT_FILENO);
            parse({"-help"});
        },
        testing::ExitedWithCode(0), "-time <ranges> +Times to work on"
    );
}

TEST(commandLine, bannerHasTheFieldsOfALog)
{
    const TestCase testCase;
    testing::internal::CaptureStdout();
    parse({"-case", testCase.dir().string()}).printBanner();
    const std::string banner = testing::internal::GetCapturedStdout();
    const std::vector<std::string> lines
    {
        "Build  : ", "Exec   : granularFoamSPH -case " + testCase.dir().string(),
        "Date   : ", "Time   : ", "Host   : ",
        "PID    : " + std::to_string(::getpid()),
        "Case   : " + testCase.dir().string(), "nProcs : "
    };
    for (const std::string& line : lines)
    {
        EXPECT_CONTAINS(banner, "\n" + line);
    }
}

} // namespace sph
