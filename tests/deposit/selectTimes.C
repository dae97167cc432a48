#include "deposit/selectTimes.H"

#include <gtest/gtest.h>

using namespace sph;

static const std::vector<Time::Instant> written
{
    {0, "0"}, {0.05, "0.05"}, {0.1, "0.1"}, {0.333333, "0.333333"}, {1, "1"}
};

static std::string selected(const std::string& list)
{
    std::string names;
    for (const Time::Instant& time : selectTimes(written, list))
    {
        names += time.name + ' ';
    }
    return names;
}

TEST(selectTimes, listsAndRanges)
{
    EXPECT_EQ(selected("0.05,0.1"), "0.05 0.1 ");
    EXPECT_EQ(selected("1 0.1 0.1"), "0.1 1 ");
    EXPECT_EQ(selected("0:0.1"), "0 0.05 0.1 ");
    EXPECT_EQ(selected("0.2:"), "0.333333 1 ");
    EXPECT_EQ(selected(":0.07,1"), "0 0.05 1 ");
    EXPECT_EQ(selected("0.3333333"), "0.333333 ");
}

TEST(selectTimes, refusesWhatIsNotThere)
{
    EXPECT_THROW(selected("0.2"), Error);
    EXPECT_THROW(selected("2:3"), Error);
    EXPECT_THROW(selected("latest"), Error);
    EXPECT_THROW(selected("0.1s"), Error);
    EXPECT_THROW(selected(","), Error);
    try
    {
        selected("0.2");
    }
    catch (const Error& error)
    {
        const std::string text = error.what();
        EXPECT_NE(text.find("0.333333"), std::string::npos);
    }
}
