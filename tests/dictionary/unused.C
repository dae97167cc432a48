#include "support.H"

using namespace sph;

namespace
{

const auto refuse = [](const dictionary& dict)
{
    return [&dict] { dict.refuseUnused(); };
};

} // namespace

TEST(DictionaryUnused, misspeltEntryIsRefusedWithASuggestion)
{
    const auto dict = parse("a 1;\nmaxC 0.2;\n");
    dict.get<scalar>("a");
    dict.getOrDefault<scalar>("maxCo", 0.4);
    expectError(2, "Entry 'maxC' of dictionary \"FILE\"", refuse(dict));
    expectError(2, "did you mean 'maxCo'?", refuse(dict));
}

TEST(DictionaryUnused, validEntriesAreListedWhereNoneIsNear)
{
    const auto dict = parse("whatever 1;");
    dict.found("rho");
    dict.subOrEmptyDict("muICoeffs");
    expectError(1, "2\n(\nmuICoeffs\nrho\n)", refuse(dict));
}

TEST(DictionaryUnused, nothingIsWrongWhereEverythingIsRead)
{
    const auto dict = parse("FoamFile { version 2.0; } a 1; s { b 2; }");
    dict.get<scalar>("a");
    dict.subDict("s").get<scalar>("b");
    EXPECT_NO_THROW(dict.refuseUnused());
}

TEST(DictionaryUnused, foundDoesNotUse)
{
    const auto dict = parse("a 1;");
    EXPECT_TRUE(dict.found("a"));
    EXPECT_THROW(dict.refuseUnused(), IOError);
}

TEST(DictionaryUnused, isLookedForInSubDictionaries)
{
    const auto dict = parse("s\n{\n t { b 1;\n bb 2; }\n}");
    const auto& t = dict.subDict("s").subDict("t");
    t.get<label>("b");
    expectError(4, "'bb' of dictionary \"FILE.s.t\"", refuse(dict), "FILE.s.t");
}

TEST(DictionaryUnused, isLookedForInListsOfDictionaries)
{
    const auto dict = parse("list\n(\n one { a 1;\n b 2; }\n);");
    dict.dictList("list")[0].second->get<label>("a");
    expectError(4, "'b'", refuse(dict), "FILE.list.one");
    dict.markUsed("list");
    EXPECT_NO_THROW(dict.refuseUnused());
}

TEST(DictionaryUnused, subDictionaryNobodyAskedForIsRefusedAsAWhole)
{
    const auto dict = parse("a 1; muCoeffs { mus 1; }");
    dict.get<label>("a");
    dict.optionalSubDict("muICoeffs");
    expectError(1, "did you mean 'muICoeffs'?", refuse(dict));
}

TEST(DictionaryUnused, sourcesOfMacrosAreUsed)
{
    const auto dict = parse
    (
        "dx 0.1; n 2; on yes; m { a 1; } grain { d 1; }\n"
        "h $dx; k #eval{ 2*$n }; s { $m; } d $grain.d;\n"
        "#if $on\n#endif"
    );
    dict.get<scalar>("h");
    dict.get<scalar>("k");
    dict.get<scalar>("d");
    dict.subDict("s").get<scalar>("a");
    EXPECT_THROW(dict.refuseUnused(), IOError);
    dict.markUsed("grain");
    EXPECT_NO_THROW(dict.refuseUnused());
}

TEST(DictionaryUnused, entriesInsertedByAMacroMustBeUsed)
{
    const auto dict = parse("m { a 1; b 2; }\ns { $m; }");
    dict.subDict("s").get<label>("a");
    expectError(1, "'b' of dictionary \"FILE.s\"", refuse(dict), "FILE.s");
}

TEST(DictionaryUnused, patternsAreUsedOnceMatched)
{
    const auto dict = parse("\"wall.*\" slip; \"base.*\" stick;");
    dict.get<word>("wall1");
    expectError(1, "'base.*'", refuse(dict));
    dict.get<word>("base1");
    EXPECT_NO_THROW(dict.refuseUnused());
}

TEST(DictionaryMissing, isNamedWithFileScopeAndSuggestion)
{
    const auto dict = parse("s\n{\n    rhos 1;\n}\n");
    const auto& s = dict.subDict("s");
    const auto get = [&] { s.get<scalar>("rho"); };
    expectError(1, "Entry 'rho' not found in dictionary \"FILE.s\"", get,
        "FILE.s");
    expectError(1, "is 'rhos' at line 3 meant", get, "FILE.s");
    try
    {
        get();
    }
    catch (const IOError& error)
    {
        EXPECT_EQ(error.endLine(), 4);
    }
}

TEST(DictionaryMissing, fromAnEmptyDictionaryNamesItsScope)
{
    const auto dict = parse("a 1;");
    const auto& empty = dict.subOrEmptyDict("muICoeffs");
    expectError
    (
        1, "not found in dictionary \"FILE.muICoeffs\"",
        [&] { empty.get<scalar>("mus"); }, "FILE.muICoeffs"
    );
}

TEST(DictionaryMissing, forgottenSemicolonIsFoundFromBothSides)
{
    const auto dict = parse("\n\ndeltaT 0.001\nwriteControl timeStep;");
    const std::string hint = "is a ';' missing at the end of line 3";
    expectError(3, hint, [&] { dict.get<scalar>("deltaT"); });
    expectError(3, "2 excess tokens: 'writeControl timeStep'",
        [&] { dict.get<scalar>("deltaT"); });
    expectError(3, hint, [&] { dict.get<word>("writeControl"); });
}
