#include "support.H"

using namespace sph;

TEST(DictionarySyntaxErrors, pointToWhatWasOpened)
{
    expectParseError(2, "'('", "a 1;\nb (1 (2 3);\nc 4;");
    expectParseError(2, "'('", "a 1;\nb\t(1\n2;\nc 4;");
    expectParseError(2, "'('", "s {\nb (1 2\n}\n", "FILE.s");
    expectParseError(2, "'('", "a 1;\nb (1 2\n\n");
    expectParseError(2, "'b'", "a { x 1; }\nb\n{\n c 1;\n", "FILE.b");
    expectParseError(2, "/*", "a 1;\n/* open\n b 2;\n");
    expectParseError(2, "'['", "a 1;\nb [0 1 ;\nc 2;");
    expectParseError(2, "no end", "a 1;\nb \"no end;\nc 2;\n");
    expectParseError(2, "#{", "a 1;\nb #{ code\n;\nc 2;\n");
    expectParseError(2, "'{'", "a 1;\nb ${x;\nc 2;\n");
}

TEST(DictionarySyntaxErrors, pointToWhatIsTooMuch)
{
    expectParseError(2, "'}'", "a { x 1; }\n}\nb 2;");
    expectParseError(2, "')'", "a 1;\nb (1 2));\n");
}

TEST(DictionarySyntaxErrors, missingSemicolonIsNamedWhereItIsMissing)
{
    expectParseError(2, "'b' is not ended", "a 1;\nb 2\n\n\n");
    expectParseError(2, "'b' is not ended", "s {\nb 2\n}\nc 3;", "FILE.s");
    expectParseError(2, "'b' is not ended", "s {\nb 2\nc 3\n}\n", "FILE.s");
    expectParseError(2, "'b' is not ended", "a 1;\nb\n");
}

TEST(DictionarySyntaxErrors, keywordsAreWords)
{
    expectParseError(2, "number 3", "a 1;\n3 4;");
    expectParseError(2, "punctuation '('", "a 1;\n(1 2);");
    expectParseError(1, "not a regular expression", "\"a(\" 1;");
}

TEST(DictionarySyntaxErrors, numbersMustBeFinite)
{
    expectParseError(2, "1e400", "a 1;\nb 1e400;");
    expectParseError(2, "-1e400", "a 1;\nb -1e400;");
    expectParseError(1, "'1.2.3'", "a 1.2.3;");
    EXPECT_EQ(x("x 1e-400;"), "0");
    for (const std::string text : {"nan", "inf", "-inf", "NaN"})
    {
        const auto dict = parse("x " + text + ";");
        expectError(1, "must be a number", [&] { dict.get<scalar>("x"); });
    }
}

TEST(DictionarySyntaxErrors, depthIsLimited)
{
    std::string text;
    for (label i = 0; i < 5000; ++i)
    {
        text += "a { ";
    }
    EXPECT_THROW(parse(text), IOError);
    EXPECT_THROW(parse("a (" + text), IOError);
    EXPECT_THROW(parse("a " + std::string(100000, '(') + ";"), IOError);
}

TEST(DictionarySyntaxErrors, lineEndingsAndMarksOfOtherSystemsAreRead)
{
    const std::string mark = "\xEF\xBB\xBF";
    const auto dict = parse
    (
        mark + "a 1;\r\nb two;\r\n// c\r\nd (1\r\n2);"
    );
    EXPECT_EQ(dict.get<label>("a"), 1);
    EXPECT_EQ(dict.get<word>("b"), "two");
    EXPECT_EQ(dict.valueText("d"), "( 1 2 )");
}
