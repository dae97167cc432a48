#include "support.H"

using namespace sph;

namespace
{

template<class T>
void expectRefused
(
    const std::string& value, const std::string& message
)
{
    SCOPED_TRACE(value);
    const auto dict = parse("a 1;\nx " + value + ";");
    expectError(2, message, [&] { dict.get<T>("x"); });
}

} // namespace

TEST(DictionaryTyped, scalars)
{
    EXPECT_EQ(parse("x 1e-3;").get<scalar>("x"), 0.001);
    EXPECT_EQ(parse("x 0.1;").get<scalar>("x"), 0.1);
    EXPECT_EQ(parse("x +4;").get<scalar>("x"), 4);
    EXPECT_EQ(parse("x 1.23456789012345;").get<scalar>("x"), 1.23456789012345);
    expectRefused<scalar>("", "no value");
    expectRefused<scalar>("\"1\"", "string \"1\"");
    expectRefused<scalar>("1 2", "1 excess token: '2'");
    expectRefused<scalar>("{ a 1; }", "found a dictionary");
}

TEST(DictionaryTyped, labels)
{
    EXPECT_EQ(parse("x -7;").get<label>("x"), -7);
    EXPECT_EQ(parse("x 2147483647;").get<label>("x"), 2147483647);
    expectRefused<label>("3.5", "whole number");
    expectRefused<label>("1e1", "whole number");
    expectRefused<label>("3.0", "whole number");
    expectRefused<label>("2147483648", "at most 2147483647");
}

TEST(DictionaryTyped, switches)
{
    for (const std::string text : {"yes", "on", "true", "y", "t", "any", "3"})
    {
        EXPECT_TRUE(parse("x " + text + ";").get<bool>("x")) << text;
    }
    for (const std::string text : {"no", "off", "false", "n", "f", "none", "0"})
    {
        EXPECT_FALSE(parse("x " + text + ";").get<bool>("x")) << text;
    }
    expectRefused<bool>("Yes", "word 'Yes'");
    expectRefused<bool>("\"yes\"", "string");
    expectRefused<bool>("1.5", "number 1.5");
}

TEST(DictionaryTyped, words)
{
    EXPECT_EQ(parse("x muI;").get<word>("x"), "muI");
    EXPECT_EQ(parse("x \"a b\";").get<word>("x"), "a b");
    EXPECT_EQ(parse("x \"a \\\"b\\\"\";").get<word>("x"), "a \"b\"");
    expectRefused<word>("3", "must be a word");
}

TEST(DictionaryTyped, vectors)
{
    EXPECT_EQ(parse("x (1 -2 0);").get<vector>("x"), vector(1, -2));
    expectRefused<vector>("(1 2)", "three components");
    expectRefused<vector>("(1 2 3)", "two-dimensional");
    expectRefused<vector>("(1 2 0 0)", "three components");
}

TEST(DictionaryTyped, lists)
{
    const std::vector<scalar> numbers{1, 2.5, 3};
    for (const std::string text : {"(1 2.5 3)", "3(1 2.5 3)",
        "List<scalar> 3(1 2.5 3)", "nonuniform List<scalar> 3(1 2.5 3)"})
    {
        EXPECT_EQ
        (
            parse("x " + text + ";").get<std::vector<scalar>>("x"), numbers
        ) << text;
    }
    EXPECT_EQ
    (
        parse("x 2{7};").get<std::vector<label>>("x"),
        (std::vector<label>{7, 7})
    );
    EXPECT_EQ
    (
        parse("x (a \"b c\");").get<wordList>("x"), (wordList{"a", "b c"})
    );
    EXPECT_EQ
    (
        parse("x ((1 2 0) (3 4 0));").get<std::vector<vector>>("x"),
        (std::vector<vector>{{1, 2}, {3, 4}})
    );
    EXPECT_TRUE(parse("x ();").get<wordList>("x").empty());
    expectRefused<std::vector<scalar>>("3(1 2)", "announces 3 values");
    expectRefused<std::vector<scalar>>("-2(1 2)", "announces -2 values");
    expectRefused<std::vector<scalar>>("(1 a)", "word 'a'");
    expectRefused<wordList>("sand", "a list in parentheses");
}

TEST(DictionaryTyped, dictLists)
{
    const auto dict = parse("x ( one { a 1; } { a 2; } ); y (1); z 3;");
    const auto list = dict.dictList("x");
    ASSERT_EQ(list.size(), 2u);
    EXPECT_EQ(list[0].first, "one");
    EXPECT_EQ(list[1].first, "");
    EXPECT_EQ(list[0].second->get<label>("a"), 1);
    EXPECT_EQ(list[1].second->get<label>("a"), 2);
    EXPECT_EQ(list[0].second->name(), "FILE.x.one");
    expectError(1, "number 1", [&] { dict.dictList("y"); });
    expectError(1, "number 3", [&] { dict.dictList("z"); });
}

TEST(DictionaryTyped, blocksInListsHaveAScope)
{
    const auto dict = parse
    (
        "a 1; x ( one { b $a; a 2; c #eval{ $a + 1 }; } );"
    );
    const dictionary& one = *dict.dictList("x")[0].second;
    EXPECT_EQ(one.get<label>("b"), 1);
    EXPECT_EQ(one.get<label>("c"), 3);
}

TEST(DictionaryTyped, choices)
{
    const auto dict = parse("x writeNow;\ny wirteNow;");
    const wordList choices{"writeNow", "endTime"};
    EXPECT_EQ(dict.getChoice("x", choices), "writeNow");
    EXPECT_EQ(dict.getChoiceOrDefault("z", "endTime", choices), "endTime");
    const auto get = [&] { dict.getChoice("y", choices); };
    expectError(2, "did you mean 'writeNow'?", get);
    expectError(2, "2\n(\nendTime\nwriteNow\n)", get);
}

TEST(DictionaryTyped, defaultsAreGivenOnlyWhereNothingIs)
{
    const auto dict = parse("x 2; y word;");
    EXPECT_EQ(dict.getOrDefault<label>("x", 5), 2);
    EXPECT_EQ(dict.getOrDefault<label>("z", 5), 5);
    EXPECT_EQ(dict.getOrDefault("z", 5.5, dimLength), 5.5);
    EXPECT_EQ
    (
        dict.getVectorOrDefault("v", vector(1, 2), dimLength), vector(1, 2)
    );
    EXPECT_THROW(dict.getOrDefault<label>("y", 5), IOError);
}

TEST(DictionaryTyped, subDictionaries)
{
    const auto dict = parse("s { a 1; }\nv 2;");
    EXPECT_TRUE(dict.isDict("s"));
    EXPECT_FALSE(dict.isDict("v"));
    EXPECT_EQ(dict.optionalSubDict("s").get<label>("a"), 1);
    EXPECT_EQ(dict.optionalSubDict("t").get<label>("v"), 2);
    EXPECT_TRUE(dict.subOrEmptyDict("t").toc().empty());
    expectError(2, "must be a dictionary", [&] { dict.subDict("v"); });
    expectError(1, "'tt' not found", [&] { dict.subDict("tt"); });
}

TEST(DictionaryTyped, literalBeatsPatternAndTheLastPatternWins)
{
    const auto dict = parse("\"w.*\" 1; wall 2; \"wa.*\" 3;");
    EXPECT_EQ(dict.get<label>("wall"), 2);
    EXPECT_EQ(dict.get<label>("wax"), 3);
    EXPECT_EQ(dict.get<label>("wx"), 1);
    EXPECT_FALSE(dict.found("aw"));
}

TEST(DictionaryTyped, failNamesTheEntry)
{
    const auto dict = parse("a 1;\nb (1\n2);\n");
    expectError(2, "wrong", [&] { dict.fail("b", "wrong"); });
    expectError(1, "wrong", [&] { dict.fail("c", "wrong"); });
}
