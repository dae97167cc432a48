#include "support.H"

#include <sstream>

using namespace sph;

TEST(DictionaryOwnership, subDictionariesOutliveAMove)
{
    dictionary first = parse("s { a 1;\n b 2; } list ( { c 3; } );");
    const dictionary& s = first.subDict("s");
    const dictionary* const inList = first.dictList("list")[0].second;
    const dictionary& absent = first.subOrEmptyDict("absent");

    const dictionary second = std::move(first);
    EXPECT_EQ(&second.subDict("s"), &s);
    EXPECT_EQ(s.get<label>("a"), 1);
    EXPECT_EQ(inList->get<label>("c"), 3);
    EXPECT_EQ(absent.getOrDefault<label>("d", 4), 4);
    EXPECT_EQ(&second.subOrEmptyDict("absent"), &absent);
    expectError
    (
        2, "'b' of dictionary", [&] { second.refuseUnused(); }, "FILE.s"
    );
}

TEST(DictionaryOwnership, defaultDictionaryIsEmpty)
{
    const dictionary empty;
    EXPECT_TRUE(empty.toc().empty());
    EXPECT_FALSE(empty.found("a"));
    EXPECT_NO_THROW(empty.refuseUnused());
}

TEST(DictionaryPlaces, areKnown)
{
    const auto dict = parse("a 1;\ns\n{\n    b 2;\n}\n");
    EXPECT_EQ(dict.name(), "FILE");
    EXPECT_EQ(dict.file(), "FILE");
    EXPECT_EQ(dict.startLine(), 1);
    EXPECT_EQ(dict.toc(), (wordList{"a", "s"}));
    const dictionary& s = dict.subDict("s");
    EXPECT_EQ(s.name(), "FILE.s");
    EXPECT_EQ(s.startLine(), 2);
    EXPECT_EQ(s.endLine(), 5);
}

TEST(DictionaryEffective, readsBackToTheSameValues)
{
    const auto dict = parse
    (
        "FoamFile { version 2.0; }\n"
        "h #eval{ 0.1/3 }; text \"a \\\"b\\\" \\\nc\"; code #{ \"x\\\" #};\n"
        "nu nu [m^2/s] 1e-6; flag; s { a $h; t { n 3{1}; } }\n"
        "list ( one { a 1; b (1 2 3); s { c 1; } } { x \"q\"; f; } );\n"
        "\"w.*\" { k 1; } empty { } big 12345678901; v 1.0;"
    );
    EXPECT_EQ(dict.get<scalar>("h"), 0.1/3);
    std::ostringstream os;
    dict.writeEffective(os);
    const auto again = dictionary::fromString(os.str(), "FILE");

    ASSERT_EQ(again.toc(), dict.toc()) << os.str();
    for (const word& key : dict.toc())
    {
        EXPECT_EQ(again.valueText(key), dict.valueText(key)) << os.str();
    }
    EXPECT_EQ(again.get<scalar>("h"), 0.1/3);
    EXPECT_EQ(again.subDict("s").get<scalar>("a"), 0.1/3);
    EXPECT_EQ(again.get<word>("text"), "a \"b\" \nc");
    EXPECT_EQ(again.get<word>("code"), " \"x\\\" ");
    EXPECT_EQ(again.subDict("w1").get<label>("k"), 1);
    EXPECT_THROW(again.get<label>("v"), IOError);
}

// Neither comments nor the header count, nor how a number is written
TEST(DictionaryText, isThatOfTheMeaning)
{
    const auto dict = parse
    (
        "FoamFile { version 2.0; } // header\n"
        "h 0.1; s\n{\n    v (0 1e-3); /* 7 */ t { flag; }\n}\n"
    );
    const auto same = parse("h   #eval{ 1/10 }; s { v (0 0.001); t {flag;} }");
    EXPECT_EQ(dict.text(), same.text());
    EXPECT_NE(dict.text(), parse("h 0.1; s { v (0 0.001); }").text());
    EXPECT_NE(dict.text(), parse("").text());
    // Nothing has been read
    EXPECT_THROW(dict.refuseUnused(), IOError);
}

// Nobody reads it: a run with it would refuse it
TEST(DictionaryEffective, leavesOutWhatOnlyServedMacros)
{
    const auto dict = parse("h 2; a $h; s { k 3; b $k; }");
    dict.get<label>("a");
    dict.subDict("s").get<label>("b");
    std::ostringstream os;
    dict.writeEffective(os);
    const auto again = parse(os.str());
    EXPECT_EQ(again.toc(), (wordList{"a", "s"}));
    EXPECT_EQ(again.subDict("s").toc(), (wordList{"b"}));
    EXPECT_EQ(again.get<label>("a"), 2);
}

TEST(DictionaryEffective, holdsTheDefaultsThatWereAskedFor)
{
    const auto dict = parse("a 1; s { b 2; }");
    dict.getOrDefault<scalar>("c", 0.1);
    dict.getOrDefault<bool>("on", true);
    dict.getOrDefault<word>("name", "two words");
    dict.getOrDefault<word>("model", "muI");
    dict.getOrDefault<wordList>("names", {"x", "y"});
    dict.getOrDefault<label>("a", 5);
    dict.getOrDefault("limit", 1.0/0.0, dimTime);
    dict.getVectorOrDefault("g", vector(0, -9.81), dimAcceleration);
    dict.subDict("s").getOrDefault<label>("d", 4);
    dict.subOrEmptyDict("t").getOrDefault<label>("e", 5);

    std::ostringstream os;
    dict.writeEffective(os);
    const std::string text = os.str();
    EXPECT_NE
    (
        text.find("c               0.1;    // default\n"), std::string::npos
    ) << text;

    const auto again = parse(text);
    EXPECT_EQ(again.get<scalar>("c"), 0.1);
    EXPECT_TRUE(again.get<bool>("on"));
    EXPECT_EQ(again.get<word>("name"), "two words");
    EXPECT_EQ(again.get<word>("model"), "muI");
    EXPECT_EQ(again.get<wordList>("names"), (wordList{"x", "y"}));
    EXPECT_EQ(again.get<label>("a"), 1);
    EXPECT_EQ(again.get<vector>("g"), vector(0, -9.81));
    EXPECT_FALSE(again.found("limit"));
    EXPECT_EQ(again.subDict("s").get<label>("d"), 4);
    EXPECT_EQ(again.subDict("t").get<label>("e"), 5);
}
