#include "../runTime/TestCase.H"
#include "scheme/BulkModulusState.H"

#include <gtest/gtest.h>

namespace sph
{

TEST(bulkModulusState, readsWhatItWrote)
{
    const TestCase dir;
    const scalar K = 1e5/3;
    BulkModulusState{K}.write(dir.dir()/"1");
    BulkModulusState{K, {{0.1, -7}}}.write(dir.dir()/"2");

    const auto alone = BulkModulusState::read(dir.dir()/"1");
    ASSERT_TRUE(alone.has_value());
    EXPECT_EQ(alone->K, K);
    EXPECT_FALSE(alone->window.has_value());

    const auto whole = BulkModulusState::read(dir.dir()/"2");
    ASSERT_TRUE(whole && whole->window);
    EXPECT_EQ(whole->K, K);
    EXPECT_EQ(whole->window->start, 0.1);
    EXPECT_EQ(whole->window->rungs, -7);

    EXPECT_FALSE(BulkModulusState::read(dir.dir()/"3").has_value());
}

TEST(bulkModulusState, whatIsBrokenIsNamed)
{
    const TestCase dir;
    const std::vector<std::pair<const char*, const char*>> cases
    {
        {"", "K"},
        {"K 0;", "K"},
        {"K 1e5; windowStart 0;", "windowRungs"},
        {"K 1e5; windowRungs -3;", "windowStart"},
        {"K 1e5; windowStart 0; windowRungs 3;", "windowRungs"},
        {"K 1e5; windowStart 0; windowRungs -1e9;", "windowRungs"},
        {"K 1e5; windowsStart 0;", "windowsStart"},
        {"K 1e5; c 10;", "'c'"}
    };
    for (const auto& [text, entry] : cases)
    {
        dir.write("1/uniform/equationOfState", text);
        const std::string error =
            errorOf([&] { BulkModulusState::read(dir.dir()/"1"); });
        EXPECT_CONTAINS(error, "1/uniform/equationOfState");
        EXPECT_CONTAINS(error, entry);
    }
}

} // namespace sph
