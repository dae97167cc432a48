// A disk that is full, or as good as full: what was whole stays whole, nothing
// half is left, the program says what is wrong and fails, and the run can go on
// when there is room again.
#include "applications/StateFiles.H"
#include "applications/mounts.H"

#include <iterator>
#include <sstream>

using namespace sph;

namespace fs = std::filesystem;

namespace
{

// Its own mappings are files that ulimit -f cuts short
constexpr bool threadSanitizer =
#ifdef __has_feature
#if __has_feature(thread_sanitizer)
    true ||
#endif
#endif
    false;

// No file may grow beyond so many blocks of 512 bytes. This is not told by a
// signal but, as a full disk is, by the write that fails.
std::string limit(const label blocks)
{
    return "trap '' XFSZ && ulimit -f " + std::to_string(blocks);
}

std::map<std::string, std::string> allFiles(const AppCase& where)
{
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(where.dir()))
    {
        if (entry.is_regular_file())
        {
            const fs::path name = fs::relative(entry.path(), where.dir());
            files[name.string()] = where.text(name.string());
        }
    }
    return files;
}

void expectRefused(const Outcome& outcome, const AppCase& where)
{
    EXPECT_EQ(outcome.code, 1);
    EXPECT_TRUE(says(outcome, "--> FOAM FATAL ERROR:\nCannot write "));
    EXPECT_TRUE(says(outcome, ": File too large"));
    EXPECT_TRUE(says(outcome, " exiting"));
    EXPECT_FALSE(contains(outcome.text, ".tmp"));
    EXPECT_FALSE(where.hasTemporary());
}

// Every row of every table has as many words as the line of its columns
void expectWholeRows(const AppCase& where)
{
    for (const auto& [name, text] : allFiles(where))
    {
        if (name.find(".dat") == std::string::npos || text.empty())
        {
            continue;
        }
        EXPECT_EQ(text.back(), '\n') << name;
        const auto words = [](const std::string& line)
        {
            std::istringstream is(line);
            return std::distance
            (
                std::istream_iterator<std::string>(is),
                std::istream_iterator<std::string>()
            );
        };
        std::istringstream lines(text);
        std::ptrdiff_t columns = 0;
        for (std::string line; std::getline(lines, line); )
        {
            if (line[0] != '#')
            {
                EXPECT_EQ(words(line), columns) << name;
            }
            columns = line[0] == '#' ? words(line.substr(1)) : columns;
        }
    }
}

} // namespace

TEST(fullDisk, aRunKeepsItsLastTimeAndGoesOn)
{
    if (threadSanitizer)
    {
        GTEST_SKIP() << "no limit of file sizes beside the thread sanitizer";
    }
    const AppCase whole, where;
    for (const AppCase* one : {&whole, &where})
    {
        one->set("system/controlDict", "writeInterval", "0.005");
        one->succeed("setParticles");
    }
    whole.succeed("granularFoamSPH");
    where.set("system/controlDict", "endTime", "0.005");
    where.succeed("granularFoamSPH");
    where.set("system/controlDict", "endTime", "0.02");
    const auto before = stateOf(where, "0.005");

    // None of the settings, none of walls.vtp, none of granular.vtp
    const auto size = [&](const char* file)
    {
        return label(fs::file_size(where.dir()/"0.005"/file)/512);
    };
    const label walls = size("walls.vtp"), granular = size("granular.vtp");
    for (const label blocks : {0, 1, 20, walls - 1, granular - 1})
    {
        const Outcome outcome =
            where.run("granularFoamSPH", 1, limit(blocks));
        expectRefused(outcome, where);
        expectSame(stateOf(where, "0.005"), before);
        EXPECT_EQ(where.latestTime(), "0.005") << blocks;
        EXPECT_EQ(Time::findTimes(where.dir()).size(), 2u) << blocks;
        expectWholeRows(where);
    }
    where.succeed("granularFoamSPH");
    for (const char* time : {"0.01", "0.02"})
    {
        expectSame(stateOf(where, time), stateOf(whole, time));
    }
}

TEST(fullDisk, setParticlesKeepsTheOldParticles)
{
    if (threadSanitizer)
    {
        GTEST_SKIP() << "no limit of file sizes beside the thread sanitizer";
    }
    const AppCase where;
    where.succeed("setParticles");
    const auto before = allFiles(where);
    where.set("system/setParticlesDict", "nr", "12");
    for (const label blocks : {0, 1, 20, 80})
    {
        expectRefused(where.run("setParticles", 1, limit(blocks)), where);
        auto after = allFiles(where);
        after["system/setParticlesDict"] = before.at("system/setParticlesDict");
        EXPECT_EQ(after, before);
    }
    where.succeed("setParticles");
    EXPECT_NE(where.text("0/granular.vtp"), before.at("0/granular.vtp"));
}

TEST(fullDisk, postRunoutLeavesNoHalfRow)
{
    if (threadSanitizer)
    {
        GTEST_SKIP() << "no limit of file sizes beside the thread sanitizer";
    }
    const AppCase where;
    where.succeed("setParticles");
    where.succeed("granularFoamSPH");
    for (const label blocks : {0, 1, 2})
    {
        expectRefused(where.run("postRunout", 1, limit(blocks)), where);
        expectWholeRows(where);
    }
    where.succeed("postRunout");
}

TEST(fullDisk, whatCannotBePrintedIsAnError)
{
    const AppCase where;
    where.succeed("setParticles");
    where.succeed("granularFoamSPH");
    for
    (
        const word command :
        {"granularFoamSPH -listModels", "setParticles", "postRunout"}
    )
    {
        const Outcome outcome = where.run(command + " > /dev/full");
        EXPECT_EQ(outcome.code, 1) << command;
        EXPECT_TRUE(says(outcome, "Cannot write all of the output"));
    }
}

// The real thing, where this user may mount one
TEST(fullDisk, aSmallDiskThatFillsUp)
{
    const AppCase whole, where;
    if (!mayMount(where))
    {
        GTEST_SKIP() << "this user may not mount";
    }
    for (const AppCase* one : {&whole, &where})
    {
        one->set("system/controlDict", "writeInterval", "0.002");
        one->succeed("setParticles");
    }
    whole.succeed("granularFoamSPH");

    where.mkdir("disk");
    where.mkdir("after");
    const Outcome outcome = withMounts
    (
        where,
        "mount -t tmpfs -o size=500k none disk"
        " && cp -R 0 constant system disk && export OMP_NUM_THREADS=1;"
        " '" SPH_BIN_DIR "'/granularFoamSPH -case disk > log; echo code $?;"
        " cp -R disk/. after"
    );
    EXPECT_TRUE(says(outcome, "code 1"));
    EXPECT_TRUE(says(outcome, "No space left on device"));
    EXPECT_FALSE(where.hasTemporary());

    // What fitted is as it should be, and what is missing can be made
    const auto times = Time::findTimes(where.dir()/"after");
    ASSERT_GT(times.size(), 2u);
    ASSERT_LT(times.size(), 11u);
    for (const Time::Instant& time : times)
    {
        EXPECT_EQ
        (
            where.text("after/" + time.name + "/granular.vtp"),
            whole.text(time.name + "/granular.vtp")
        );
    }
    where.succeed("granularFoamSPH -case after");
    EXPECT_EQ
    (
        where.text("after/0.02/granular.vtp"),
        whole.text("0.02/granular.vtp")
    );
}
