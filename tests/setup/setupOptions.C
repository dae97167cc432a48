#include "setup/setupOptions.H"

#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

using namespace sph;
namespace fs = std::filesystem;

namespace
{

class SetupOptions : public testing::Test
{
protected:
    const fs::path caseDir_ =
        fs::path(testing::TempDir())
       /("setupOptions" + std::to_string(getpid()));
    const dictionary controlDict_ = dictionary::fromString
    (
        "startFrom startTime; startTime 0.25; endTime 1; maxCo 0.4;"
        "adjustTimeStep yes; writeControl adjustable; writeInterval 0.5;"
    );

    void SetUp() override { fs::create_directories(caseDir_/"system"); }
    void TearDown() override { fs::remove_all(caseDir_); }

    CommandLine line(std::vector<std::string> words) const
    {
        words.insert(words.begin(), {"setParticles", "-case", caseDir_});
        std::vector<char*> argv;
        for (std::string& text : words)
        {
            argv.push_back(text.data());
        }
        return CommandLine
        (
            int(argv.size()), argv.data(), "",
            {{"dict", "file", ""}, {"time", "time", ""}}
        );
    }
};

} // namespace


TEST_F(SetupOptions, withoutAnyTheCaseDecides)
{
    EXPECT_EQ
    (
        setupDictPath(line({})), caseDir_/"system"/"setParticlesDict"
    );
    const Time::Instant start = setupTime(line({}), controlDict_);
    EXPECT_EQ(start.value, 0.25);
    EXPECT_EQ(start.name, "0.25");
}

TEST_F(SetupOptions, timeNamesTheFolder)
{
    const Time::Instant start = setupTime
    (
        line({"-time", "0.10"}), controlDict_
    );
    EXPECT_EQ(start.value, 0.1);
    EXPECT_EQ(start.name, "0.10");
    EXPECT_THROW(setupTime(line({"-time", "now"}), controlDict_), Error);
}

TEST_F(SetupOptions, dictIsLookedForInTheCaseAndItsSystem)
{
    EXPECT_THROW(setupDictPath(line({"-dict", "other"})), Error);
    std::ofstream(caseDir_/"system"/"other") << ';';
    EXPECT_EQ
    (
        setupDictPath(line({"-dict", "other"})), caseDir_/"system"/"other"
    );
    EXPECT_EQ
    (
        setupDictPath(line({"-dict", "system/other"})),
        caseDir_/"system"/"other"
    );
    EXPECT_EQ
    (
        setupDictPath(line({"-dict", caseDir_/"system"/"other"})),
        caseDir_/"system"/"other"
    );
}
