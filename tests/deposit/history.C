#include "deposit/history.H"

#include <cmath>
#include <gtest/gtest.h>

using namespace sph;

TEST(settlingTime, isTheFirstTimeOfTheLastQuietSpell)
{
    const std::vector<scalar> times{0, 1, 2, 3, 4, 5};
    EXPECT_EQ(settlingTime(times, {0, 0, 5, 7, 7.05, 7.1}, 0.2), 3);
    EXPECT_EQ(settlingTime(times, {3, 3, 3, 3, 3, 3}, 0.2), 0);
}

TEST(settlingTime, seesASlowCreep)
{
    // each step is small, their sum is not
    const std::vector<scalar> times{0, 1, 2, 3, 4, 5};
    EXPECT_EQ(settlingTime(times, {0, 0.1, 0.2, 0.3, 0.4, 0.5}, 0.25), 3);
}

TEST(settlingTime, comparesAllLaterValues)
{
    const std::vector<scalar> times{0, 1, 2, 3};
    EXPECT_EQ(settlingTime(times, {1.06, 1.04, 0.8, 1}, 0.25), 1);
    EXPECT_EQ(settlingTime(times, {0.74, 0.76, 1, 0.9}, 0.25), 1);
}

TEST(settlingTime, isNoNumberWhileMoving)
{
    EXPECT_TRUE(std::isnan(settlingTime({0, 1, 2}, {0, 1, 2}, 0.5)));
    EXPECT_TRUE(std::isnan(settlingTime({0}, {1}, 0.5)));
    EXPECT_TRUE(std::isnan(settlingTime({}, {}, 0.5)));
    const scalar nan = std::nan("");
    EXPECT_TRUE(std::isnan(settlingTime({0, 1, 2}, {1, nan, 1}, 0.5)));
}

TEST(RecentValues, knowsNoChangeBeforeItsWindowIsFull)
{
    RecentValues values(1);
    EXPECT_TRUE(std::isinf(values.change()));
    values.add(0, 5);
    values.add(0.9, 5);
    EXPECT_TRUE(std::isinf(values.change()));
    values.add(1.0, 5.5);
    EXPECT_DOUBLE_EQ(values.change(), 0.5);
}

TEST(RecentValues, forgetsWhatIsOlderThanItsWindow)
{
    RecentValues values(1);
    for (label i = 0; i <= 40; ++i)
    {
        values.add(0.1*i, i < 20 ? i : 20);
    }
    EXPECT_DOUBLE_EQ(values.change(), 0);
    values.add(4.1, 21);
    EXPECT_DOUBLE_EQ(values.change(), 1);
}
