// Text that was made to exhaust a reader: an error, not time, memory or stack.
#include "support.H"

#include <cmath>

using namespace sph;

static std::string repeated(const std::string& text, const label times)
{
    std::string all;
    for (label i = 0; i < times; ++i)
    {
        all += text;
    }
    return all;
}

// Each pattern has more ways to match than could ever be tried
TEST(DictionaryHostile, patternsAreMatchedInTime)
{
    const std::string many(400, 'a');
    for (const std::string pattern : {"(a|a)*b", "(a*)*b", "(a+)+b", "(.*)*b"})
    {
        const auto dict = parse('"' + pattern + "\" 1; other 2;");
        EXPECT_FALSE(dict.found(many)) << pattern;
        EXPECT_TRUE(dict.found("aab")) << pattern;
    }
}

TEST(DictionaryHostile, patternsAreOfASize)
{
    expectParseError
    (
        2, "too large for a regular expression", "a 1;\n\"((a{99}){99}){99}\" 1;"
    );
    expectParseError
    (
        1, "too large for a regular expression", "\"b{1,99999999999}\" 1;"
    );
    expectParseError(1, "not a regular expression", R"("(a)\1" 1;)");
    EXPECT_TRUE(parse("\"(in|out)let_[0-9]{1,3}\" 1;").found("outlet_17"));
}

TEST(DictionaryHostile, keywordsAreOfALength)
{
    const std::string keyword(501, 'k');
    expectParseError(2, "501 characters", "a 1;\n" + keyword + " 2;");
    expectParseError(2, "501 characters", "a 1;\nb $" + keyword + ';');
    EXPECT_EQ(parse("k" + std::string(499, 'k') + " 2;").toc().size(), 1u);

    // Nothing matches what no keyword can be
    EXPECT_FALSE(parse("\".*\" 1;").found(keyword));
}

TEST(DictionaryHostile, macrosDoNotGrowWithoutEnd)
{
    std::string lists = "x0 (1 1 1 1 1 1 1 1);\n";
    std::string dicts = "x0 { a 1; }\n";
    std::string nested = "x0 { a 1; }\n";
    for (label i = 1; i < 5000; ++i)
    {
        const std::string x = "x" + std::to_string(i);
        const std::string before = "$x" + std::to_string(i - 1);
        lists += x + " (" + before + ' ' + before + ");\n";
        dicts += x + " { b { " + before + "; } c { " + before + "; } }\n";
        nested += x + " { b { " + before + "; } }\n";
    }
    for (const std::string& text : {lists, dicts, nested})
    {
        std::string error;
        try
        {
            parse(text);
        }
        catch (const IOError& refused)
        {
            error = refused.what();
        }
        EXPECT_EQ(error, "The macros stand for more than 20 MB of entries");
    }
}

// A dictionary of dictionaries that take any name: each dot of the macro may
// belong to any of them
TEST(DictionaryHostile, scopedNamesAreSearchedOnce)
{
    const std::string text =
        repeated("\".*\" { ", 40) + "c 1; " + repeated("} ", 40);
    EXPECT_NO_THROW(parse(text + "$" + repeated("a.", 60) + "b;"));
}

TEST(DictionaryHostile, repeatedValuesAreCounted)
{
    const auto dict = parse("a 1;\nb 2147483647{ 1 };\nc 3{ 2 };");
    expectError
    (
        2, "repeats a value 2147483647 times",
        [&] { dict.get<std::vector<scalar>>("b"); }
    );
    EXPECT_EQ(dict.get<std::vector<scalar>>("c").size(), 3u);
}

TEST(DictionaryHostile, whatIsNotFiniteIsRefused)
{
    const std::string digits(400, '9');
    expectParseError(2, "too large to be finite", "a 1;\nb " + digits + "e-5;");
    EXPECT_EQ(parse("b 0." + repeated("0", 400) + "1;").get<scalar>("b"), 0);

    const auto dict = parse("a [Mm] (1e305 0 0);\nb [km] 1e306;");
    expectError(1, "not finite", [&] { dict.getVector("a", dimLength); });
    expectError(2, "finite", [&] { dict.get("b", dimLength); });
}

TEST(DictionaryHostile, namesThatNoFileCanHave)
{
    const std::string name(5000, 'n');
    expectParseError(1, "Cannot open the file", "#include \"" + name + "\"");
    EXPECT_TRUE(parse("#sinclude \"" + name + "\"\na 1;").found("a"));
}

TEST(DictionaryHostile, nestedParenthesesOfWords)
{
    expectParseError(1, "", "a " + repeated("vector(", 30000) + "1;");
}

TEST(DictionaryHostile, dictionariesAndNothingBehindThem)
{
    expectParseError
    (
        3, "Entry 'b' is a dictionary", "a { x 1; }\nc 1;\nb $a more;"
    );
    EXPECT_TRUE(parse("a { x 1; }\nb $a;").isDict("b"));
}

TEST(DictionaryHostile, byteOrderMarksAnywhere)
{
    const std::string mark = "\xEF\xBB\xBF";
    const auto dict = parse(mark + "a 1;\n" + mark + mark + "b 2;" + mark);
    EXPECT_EQ(dict.toc(), (wordList{"a", "b"}));
}
