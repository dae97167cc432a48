#include "selection/Libraries.H"
#include "selection/Selectable.H"

#include <gtest/gtest.h>

using namespace sph;

TEST(Libraries, aLibraryThatIsNotThereIsAnError)
{
    const auto dict = dictionary::fromString
    (
        "deltaT 1;\nlibs (\"libnoSuchModels.so\");", "controlDict"
    );
    try
    {
        loadLibraries(dict, ".");
        FAIL() << "nothing was thrown";
    }
    catch (const IOError& error)
    {
        EXPECT_EQ(error.startLine(), 2);
        EXPECT_NE
        (
            std::string(error.what()).find("libnoSuchModels.so"),
            std::string::npos
        );
    }
}

TEST(Libraries, theEntryIsOptionalAndALibraryLoads)
{
    EXPECT_NO_THROW(loadLibraries(dictionary::fromString("a 1;"), "."));
    EXPECT_NO_THROW
    (
        loadLibraries(dictionary::fromString("libs (\"libm.so.6\");"), ".")
    );
}

TEST(Libraries, aKeywordTakenTwiceIsAnError)
{
    EXPECT_NO_THROW(SelectionTables::checkUnique());
    SelectionTables::add("testFamily", "twin", "first");
    EXPECT_NO_THROW(SelectionTables::checkUnique());
    SelectionTables::add("testFamily", "twin", "second");
    EXPECT_THROW(SelectionTables::checkUnique(), Error);
}
