// A time folder is there as a whole or not at all.
#include "io/writeTimeFolder.H"
#include "runTime/TestCase.H"

using namespace sph;

namespace
{

namespace fs = std::filesystem;

struct writtenFolder : testing::Test
{
    TestCase testCase;
    const fs::path folder = testCase.dir()/"0.05";

    static void put(const fs::path& file, const std::string& text)
    {
        fs::create_directories(file.parent_path());
        std::ofstream(file) << text;
    }

    // Names below the case, hidden ones included
    std::set<std::string> names() const
    {
        std::set<std::string> names;
        for
        (
            const auto& entry :
            fs::recursive_directory_iterator(testCase.dir())
        )
        {
            names.insert(fs::relative(entry.path(), testCase.dir()).string());
        }
        return names;
    }
};

} // namespace

TEST_F(writtenFolder, appearsWhenItIsComplete)
{
    writeTimeFolder(folder, [&](const fs::path& path)
    {
        EXPECT_EQ(path.filename(), "0.05");
        put(path/"uniform"/"time", "t");
        put(path/"granular.vtp", "g");
        EXPECT_FALSE(fs::exists(folder));
        EXPECT_TRUE(Time::findTimes(testCase.dir()).empty());
    });
    EXPECT_EQ
    (
        names(),
        (std::set<std::string>
        {
            "0.05", "0.05/granular.vtp", "0.05/uniform", "0.05/uniform/time"
        })
    );
}

TEST_F(writtenFolder, takesThePlaceOfAnother)
{
    put(folder/"uniform"/"sleep", "old");
    put(folder/"walls.vtp", "old");
    put(folder/"granular.vtp", "old");
    put(folder/"notes", "mine");
    writeTimeFolder(folder, [&](const fs::path& path)
    {
        put(path/"uniform"/"time", "new");
        put(path/"granular.vtp", "new");
        EXPECT_EQ(testCase.text("0.05/granular.vtp"), "old");
    });
    EXPECT_EQ(testCase.text("0.05/granular.vtp"), "new");
    EXPECT_EQ(testCase.text("0.05/uniform/time"), "new");
    EXPECT_EQ(testCase.text("0.05/notes"), "mine");
    EXPECT_FALSE(testCase.has("0.05/walls.vtp"));
    EXPECT_FALSE(testCase.has("0.05/uniform/sleep"));
}

TEST_F(writtenFolder, isAsBeforeIfItFails)
{
    put(folder/"uniform"/"time", "old");
    put(folder/"granular.vtp", "old");
    const auto before = names();
    const std::string error = errorOf([&]
    {
        writeTimeFolder(folder, [&](const fs::path& path)
        {
            put(path/"uniform"/"time", "new");
            throw Error("Cannot write " + (path/"walls.vtp").string());
        });
    });
    EXPECT_CONTAINS(error, "Cannot write " + (folder/"walls.vtp").string());
    EXPECT_EQ(names(), before);
    EXPECT_EQ(testCase.text("0.05/uniform/time"), "old");
}

TEST_F(writtenFolder, whatAKillHasLeftIsRemoved)
{
    put(testCase.dir()/".0.05.tmp12"/"0.05"/"uniform"/"time", "half");
    put(testCase.dir()/"VTK"/".a.vtp.series.tmp345", "half");
    put(testCase.dir()/"effective"/"0"/"system"/".controlDict.tmp6", "half");
    const std::map<std::string, std::string> others
    {
        {".git/.0.tmp7", "x"}, {".0.05.tmp12b/0.05/a", "x"},
        {".notes.tmp8", "x"}, {"VTK/a.vtp.series", "x"}, {"0/granular.vtp", "x"}
    };
    for (const auto& [name, text] : others)
    {
        put(testCase.dir()/name, text);
    }
    removeUnfinished(testCase.dir());
    std::map<std::string, std::string> left;
    for (const std::string& name : names())
    {
        if (fs::is_regular_file(testCase.dir()/name))
        {
            left[name] = testCase.text(name);
        }
    }
    EXPECT_EQ(left, others);
}
