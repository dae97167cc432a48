#include "support.H"

using namespace sph;

TEST(DictionaryMacros, takeTheValueKnownWhenRead)
{
    const auto dict = parse("a 1; b $a; a 2;");
    EXPECT_EQ(dict.get<label>("b"), 1);
    EXPECT_EQ(dict.get<label>("a"), 2);
}

TEST(DictionaryMacros, searchOutwardsAndNotInwards)
{
    EXPECT_EQ(parse("a 1; s { t { b $a; } }").valueText("s.t.b"), "1");
    EXPECT_EQ(parse("a 1; s { a 2; b $..a; }").valueText("s.b"), "1");
    expectParseError(2, "$a'", "s { a 1; }\nb $a;");
}

TEST(DictionaryMacros, seeTheDictionaryStillBeingRead)
{
    EXPECT_EQ(parse("s { a 3; b $:s.a; }").valueText("s.b"), "3");
}

TEST(DictionaryMacros, haveDefaults)
{
    EXPECT_EQ(x("x ${sphNotThere:-7};"), "7");
    EXPECT_EQ(x("a 2; x ${a:-7};"), "2");
    EXPECT_EQ(x("x ${sphNotThere:-(1 2)};"), "( 1 2 )");
}

TEST(DictionaryMacros, namesMayHoldMacros)
{
    EXPECT_EQ(x("grain { d 4; } which grain; x ${${which}.d};"), "4");
}

TEST(DictionaryMacros, standForWholeDictionaries)
{
    const auto dict = parse("m { a 1; s { b 2; } } c $m; d { $m; a 3; }");
    EXPECT_EQ(dict.valueText("c.s.b"), "2");
    EXPECT_EQ(dict.valueText("d.a"), "3");
    EXPECT_EQ(dict.valueText("d.s.b"), "2");
    EXPECT_EQ(dict.subDict("d").subDict("s").name(), "FILE.d.s");
}

TEST(DictionaryMacros, standForDictionariesInLists)
{
    const auto dict = parse("m { a 1; } list ( one $m two { a 2; } );");
    const auto list = dict.dictList("list");
    ASSERT_EQ(list.size(), 2u);
    EXPECT_EQ(list[0].first, "one");
    EXPECT_EQ(list[0].second->get<label>("a"), 1);
    EXPECT_EQ(list[1].second->get<label>("a"), 2);
}

TEST(DictionaryMacros, standForKeywords)
{
    EXPECT_EQ(x("name x; $name 5;"), "5");
    expectParseError(2, "must stand for a dictionary", "n 3;\n$n 5;");
}

TEST(DictionaryMacros, areNamedWithASuggestionIfUndefined)
{
    expectParseError(3, "'$rhoo'", "rho 1;\n\nmass $rhoo;");
    expectParseError(3, "did you mean 'rho'?", "rho 1;\n\nmass $rhoo;");
    expectParseError(2, "so far up", "a 1;\ns { b $...a; }", "FILE.s");
}

TEST(DictionaryMacros, readTheEnvironment)
{
    setenv("SPH_TEST_VALUE", "2.5", 1);
    setenv("SPH_TEST_PATH", "/tmp/x", 1);
    EXPECT_EQ(x("x $SPH_TEST_VALUE;"), "2.5");
    EXPECT_EQ(parse("x $SPH_TEST_PATH;").get<word>("x"), "/tmp/x");
    EXPECT_EQ(x("SPH_TEST_VALUE 3; x $SPH_TEST_VALUE;"), "3");
    unsetenv("SPH_TEST_VALUE");
    unsetenv("SPH_TEST_PATH");
}

TEST(DictionaryMacros, endWhereAListBegins)
{
    EXPECT_EQ(x("n 2; x $n(1 2);"), "2 ( 1 2 )");
    EXPECT_EQ(x("x uniform(1 0 0);"), "uniform ( 1 0 0 )");
    EXPECT_EQ(x("x div(phi,U);"), "div(phi,U)");
}

TEST(DictionaryConditionals, chooseBranches)
{
    EXPECT_EQ(x("#if yes\nx 1;\n#else\nx 2;\n#endif"), "1");
    EXPECT_EQ(x("a off;\n#if $a\nx 1;\n#else\nx 2;\n#endif"), "2");
    EXPECT_EQ(x("n 4;\n#if #eval{ $n > 3 }\nx 1;\n#endif"), "1");
    EXPECT_EQ(x("n 4;\n#ifeq $n 4.0\nx 1;\n#endif"), "1");
    EXPECT_FALSE(parse("#ifeq a b\nx 1;\n#endif").found("x"));
}

TEST(DictionaryConditionals, mustBeClosedWhereTheyOpen)
{
    expectParseError(2, "#if", "a 1;\n#if yes\nb 1;\n");
    expectParseError(2, "#if", "a 1;\n#if no\nb 1;\n");
    expectParseError(2, "#if", "s {\n#if yes\nb 1; }\n#endif", "FILE.s");
    expectParseError(1, "#endif without", "#endif");
    expectParseError(2, "#else without", "\n#else\na 1;");
    expectParseError(1, "'maybe'", "#if maybe\n#endif");
}

TEST(DictionaryDirectives, removeEntries)
{
    const auto dict = parse
    (
        "a1 1; a2 2; b 3; c 4; #remove \"a.*\"\n#remove (b c)"
    );
    EXPECT_TRUE(dict.toc().empty());
}

TEST(DictionaryDirectives, setTheInputMode)
{
    EXPECT_EQ(x("#inputMode protect\nx 1; x 2;"), "1");
    EXPECT_EQ(x("#inputMode warn\nx 1; x 2;"), "1");
    EXPECT_EQ(x("#inputMode overwrite\nx 1; x 2;"), "2");
    EXPECT_EQ(x("#inputMode error\n#inputMode default\nx 1; x 2;"), "2");
    EXPECT_FALSE
    (
        parse("#inputMode protect\ns { a 1; } s { b 1; }")
            .subDict("s").found("b")
    );
    expectParseError(3, "duplicate", "#inputMode error\nx 1;\nx 2;");
    expectParseError(1, "mrege", "#inputMode mrege");
}

TEST(DictionaryDirectives, unknownOnesAreRefused)
{
    expectParseError(2, "did you mean '#include'?", "\n#inlcude \"a\"");
    expectParseError(1, "#codeStream is not available", "x #codeStream { };");
    expectParseError(2, "'#nonsense'", "x 1\n#nonsense;");
}
