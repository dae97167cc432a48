#include "setup/readGravity.H"

#include "primitives/error.H"

#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

using namespace sph;
namespace fs = std::filesystem;

namespace
{

class ReadGravity : public testing::Test
{
protected:
    const fs::path caseDir_ =
        fs::path(testing::TempDir())
       /("readGravity" + std::to_string(getpid()));

    void SetUp() override { fs::create_directories(caseDir_/"constant"); }
    void TearDown() override { fs::remove_all(caseDir_); }

    vector read(const std::string& text) const
    {
        std::ofstream(caseDir_/"constant"/"g") << text;
        return readGravity(caseDir_);
    }

    void expectError(const std::string& text, const std::string& message) const
    {
        try
        {
            read(text);
            FAIL() << "no error for " << text;
        }
        catch (const IOError& error)
        {
            EXPECT_NE(error.block().find(message), std::string::npos)
                << error.block();
            EXPECT_NE(error.file().find("constant/g"), std::string::npos);
        }
    }
};

} // namespace


TEST_F(ReadGravity, readsTheOpenFOAMFile)
{
    EXPECT_EQ
    (
        read
        (
            "FoamFile { class uniformDimensionedVectorField; object g; }\n"
            "dimensions [0 1 -2 0 0 0 0];\nvalue (0 -9.81 0);\n"
        ),
        vector(0, -9.81)
    );
}

TEST_F(ReadGravity, refusesWhatIsNoAcceleration)
{
    expectError
    (
        "dimensions [0 1 -1 0 0 0 0]; value (0 -9.81 0);",
        "dimensions of an acceleration are [0 1 -2 0 0 0 0]"
    );
    expectError("dimensions [0 1 -2 0 0 0 0]; value (0 0 -9.81);", "value");
    expectError("value (0 -9.81 0);", "dimensions");
    expectError("dimensions [0 1 -2 0 0 0 0];", "value");
    expectError
    (
        "dimensions [0 1 -2 0 0 0 0]; value (0 -9.81 0); vlaue (0 0 0);",
        "vlaue"
    );
}

TEST_F(ReadGravity, aMissingFileIsNamed)
{
    EXPECT_THROW(readGravity(caseDir_/"nowhere"), IOError);
}
