// A case that nothing can be written into is refused before any work.
#include "applications/mounts.H"

using namespace sph;

namespace
{

// Applications in a case whose folder is on a file system for reading only
Outcome inReadOnlyCase(const AppCase& where, const std::string& words)
{
    return withMounts
    (
        where,
        "mount --bind . . && mount -o remount,bind,ro . && export"
        " OMP_NUM_THREADS=1 && '" SPH_BIN_DIR "'/" + words + " -case \"$PWD\""
    );
}

} // namespace

TEST(readOnly, isSaidBeforeAnyWork)
{
    const AppCase where;
    if (!mayMount(where))
    {
        GTEST_SKIP() << "this user may not mount";
    }
    where.succeed("setParticles");
    where.succeed("granularFoamSPH");
    const std::map<std::string, word> work
    {
        {"setParticles", "Reading"}, {"granularFoamSPH", "Create time"},
        {"granularFoamSPH -postProcess", "End"}, {"postRunout", "run-out"}
    };
    for (const auto& [words, sign] : work)
    {
        const Outcome outcome = inReadOnlyCase(where, words);
        EXPECT_EQ(outcome.code, 1) << words;
        EXPECT_TRUE(says(outcome, "--> FOAM FATAL ERROR:\nCannot "));
        EXPECT_TRUE(says(outcome, where.dir().string()));
        EXPECT_TRUE(says(outcome, ": Read-only file system"));
        EXPECT_FALSE(contains(outcome.text, sign)) << words;
    }
    EXPECT_EQ(inReadOnlyCase(where, "granularFoamSPH -dry-run").code, 0);
}

TEST(readOnly, isSaidOfAFolderWithoutPermission)
{
    const AppCase where;
    where.succeed("setParticles");
    namespace fs = std::filesystem;
    const fs::perms writing =
        fs::perms::owner_write | fs::perms::group_write
      | fs::perms::others_write;
    fs::permissions(where.dir(), writing, fs::perm_options::remove);
    const bool binds = ::access(where.dir().c_str(), W_OK) != 0;
    if (binds)
    {
        const Outcome outcome = where.run("granularFoamSPH");
        EXPECT_EQ(outcome.code, 1);
        EXPECT_TRUE(says(outcome, "Cannot write into the case"));
        EXPECT_TRUE(says(outcome, "Permission denied"));
    }
    fs::permissions(where.dir(), writing, fs::perm_options::add);
    if (!binds)
    {
        GTEST_SKIP() << "permissions do not bind this user";
    }
}
