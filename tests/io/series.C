// VTK/<case>.vtp.series: JSON with the time folders that hold particles.
#include "io/caseIO.H"
#include "runTime/TestCase.H"

#include <algorithm>
#include <cctype>

namespace sph
{

namespace
{

// Without blanks and line ends
std::string packed(std::string text)
{
    text.erase
    (
        std::remove_if
        (
            text.begin(), text.end(), [](const char c) { return std::isspace(c); }
        ),
        text.end()
    );
    return text;
}

} // namespace

TEST(series, listsTheTimesThatAreThereInOrder)
{
    const TestCase testCase;
    const std::string name = testCase.dir().filename().string();
    testCase.write("0/granular.vtp", "");
    testCase.write("0.05/granular.vtp", "");
    testCase.write("10/granular.vtp", "");
    testCase.write("2e-05/granular.vtp", "");
    testCase.write("0.05/walls.vtp", "");
    testCase.write("0.orig/granular.vtp", "");
    testCase.mkdir("0.07");

    writeSeries(testCase.dir()/"");
    EXPECT_EQ
    (
        packed(testCase.text("VTK/" + name + ".vtp.series")),
        "{\"file-series-version\":\"1.0\",\"files\":["
        "{\"name\":\"../0/granular.vtp\",\"time\":0},"
        "{\"name\":\"../2e-05/granular.vtp\",\"time\":2e-05},"
        "{\"name\":\"../0.05/granular.vtp\",\"time\":0.05},"
        "{\"name\":\"../10/granular.vtp\",\"time\":10}]}"
    );
    EXPECT_EQ
    (
        packed(testCase.text("VTK/" + name + "Walls.vtp.series")),
        "{\"file-series-version\":\"1.0\",\"files\":["
        "{\"name\":\"../0.05/walls.vtp\",\"time\":0.05}]}"
    );
}

TEST(series, followsPurgedFolders)
{
    const TestCase testCase;
    const std::string series =
        "VTK/" + testCase.dir().filename().string() + ".vtp.series";
    testCase.write("1/granular.vtp", "");
    testCase.write("2/granular.vtp", "");
    writeSeries(testCase.dir());
    std::filesystem::remove_all(testCase.dir()/"1");
    writeSeries(testCase.dir());
    EXPECT_FALSE(contains(testCase.text(series), "../1/"));
    EXPECT_CONTAINS(testCase.text(series), "../2/");
    std::filesystem::remove_all(testCase.dir()/"2");
    writeSeries(testCase.dir());
    EXPECT_FALSE(testCase.has(series));
}

TEST(series, unwritableFolderIsNamed)
{
    const TestCase testCase;
    testCase.write("1/granular.vtp", "");
    testCase.write("VTK", "a file");
    EXPECT_CONTAINS
    (
        errorOf([&]() { writeSeries(testCase.dir()); }), "vtp.series"
    );
}

} // namespace sph
