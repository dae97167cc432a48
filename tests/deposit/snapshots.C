#include "deposit/Snapshots.H"
#include "deposit/StartState.H"
#include "heaps.H"
#include "io/caseIO.H"
#include "primitives/error.H"

#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

using namespace sph;
namespace fs = std::filesystem;

class Snapshots : public testing::Test
{
protected:
    const fs::path dir_ =
        fs::temp_directory_path()/("sphSnapshots" + std::to_string(getpid()));

    void SetUp() override
    {
        for (const scalar time : {0.0, 0.1, 0.2})
        {
            Particles particles(0.01);
            heaps::place(particles, heaps::column(0.1 + time, 0.1, 0.01));
            std::ostringstream name;
            name << time;
            writeState(particles, time, dir_/name.str(), {});
        }
        fs::create_directories(dir_/"0.3");     // no particles in here
        fs::create_directories(dir_/"0.orig");
    }
    void TearDown() override { fs::remove_all(dir_); }
};


TEST_F(Snapshots, areTheTimesThatHoldParticles)
{
    const auto snapshots = caseSnapshots(dir_);
    ASSERT_EQ(snapshots.size(), 3u);
    EXPECT_EQ(snapshots[2].name, "0.2");
    EXPECT_THROW(caseSnapshots(dir_/"0.3"), Error);
}


TEST_F(Snapshots, areSelectedByTheOptions)
{
    const auto all = caseSnapshots(dir_);
    EXPECT_EQ(selectSnapshots(all, "", false, true).size(), 2u);
    EXPECT_EQ(selectSnapshots(all, "0:0.1", false, false).size(), 2u);
    const auto latest = selectSnapshots(all, "", true, false);
    ASSERT_EQ(latest.size(), 1u);
    EXPECT_EQ(latest[0].name, "0.2");
    const auto zero = selectSnapshots(all, "0", false, false);
    EXPECT_THROW(selectSnapshots(zero, "", false, true), Error);
}


TEST_F(Snapshots, readFilesWithTheirTimes)
{
    const std::string a = (dir_/"a.vtp").string();
    const std::string b = (dir_/"b.vtp").string();
    fs::copy_file(dir_/"0.2"/"granular.vtp", a);
    fs::copy_file(dir_/"0.1"/"granular.vtp", b);

    const auto own = fileSnapshots(a + " " + b, {});
    ASSERT_EQ(own.size(), 2u);
    EXPECT_DOUBLE_EQ(own[0].time, 0.1);     // sorted by TimeValue
    Particles particles;
    own[0].read(particles);
    EXPECT_EQ(particles.granular().size(), 200);

    const auto given = fileSnapshots(a + " " + b, {5, 6});
    EXPECT_DOUBLE_EQ(given[0].time, 5);
    EXPECT_EQ(given[0].path, a);
    EXPECT_THROW(fileSnapshots(a, {1, 2}), Error);
    EXPECT_THROW(fileSnapshots("nowhere.vtp", {}), Error);
}


TEST_F(Snapshots, nameABrokenFile)
{
    const fs::path broken = dir_/"broken.vtp";
    std::ofstream(broken) << "<VTKFile";
    const Snapshot snapshot{0, "0", broken};
    Particles particles;
    try
    {
        snapshot.read(particles);
        FAIL();
    }
    catch (const Error& error)
    {
        EXPECT_NE(error.block().find("broken.vtp"), std::string::npos);
    }
}


TEST_F(Snapshots, theFirstOneIsTheStartOfARestart)
{
    const auto first = readFirstState(dir_, "0.1");
    ASSERT_TRUE(first);
    EXPECT_EQ(first->granular().size(), 100);
    EXPECT_FALSE(readFirstState(dir_, "0"));
    EXPECT_FALSE(readFirstState(dir_/"0.orig", "0"));
}
