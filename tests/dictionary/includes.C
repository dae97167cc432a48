#include "support.H"

using namespace sph;

using DictionaryIncludes = Folder;

TEST_F(DictionaryIncludes, areRelativeToTheIncludingFile)
{
    write("sub/b", "#include \"c\"\nb 2;");
    write("sub/c", "c 3;");
    const auto dict = dictionary::fromFile
    (
        write("a", "#include \"sub/b\"\na 1;")
    );
    EXPECT_EQ(dict.toc(), (wordList{"c", "b", "a"}));
}

TEST_F(DictionaryIncludes, readIntoTheDictionaryTheyStandIn)
{
    write("b", "b $a;");
    const auto dict = dictionary::fromFile
    (
        write("a", "a 1; s { #include \"b\"\n}")
    );
    EXPECT_EQ(dict.valueText("s.b"), "1");
}

TEST_F(DictionaryIncludes, mayStandInAValue)
{
    write("points", "(0 0 0) (1 1 0)");
    const auto dict = dictionary::fromFile
    (
        write("a", "p (\n#include \"points\"\n);")
    );
    EXPECT_EQ(dict.get<std::vector<vector>>("p")[1], vector(1, 1));
}

TEST_F(DictionaryIncludes, expandMacrosInTheirNames)
{
    write("sub/b", "b 2;");
    setenv("SPH_TEST_FOLDER", folder.c_str(), 1);
    const auto dict = dictionary::fromFile
    (
        write
        (
            "a",
            "f sub; s { #include \"$f/b\"\n }"
            " t { #include \"${SPH_TEST_FOLDER}/sub/b\"\n }"
        )
    );
    unsetenv("SPH_TEST_FOLDER");
    EXPECT_EQ(dict.valueText("s.b"), "2");
    EXPECT_EQ(dict.valueText("t.b"), "2");
}

TEST_F(DictionaryIncludes, errorsNameTheIncludedFile)
{
    const std::string b = write("b", "ok 1;\nbad (1 2;\n");
    const std::string a = write("a", "\n#include \"b\"\n");
    expectError(2, "'bad'", [&] { dictionary::fromFile(a); }, b);
}

TEST_F(DictionaryIncludes, typedReadsNameTheIncludedFile)
{
    const std::string b = write("b", "ok 1;\nbad word;\n");
    const auto dict = dictionary::fromFile
    (
        write("a", "s\n{\n#include \"b\"\n}\n")
    );
    const auto& s = dict.subDict("s");
    expectError(2, "'bad'", [&] { s.get<scalar>("bad"); }, b + ".s");
}

TEST_F(DictionaryIncludes, missingFilesAreNamed)
{
    const std::string a = write("a", "\n#include \"notHere\"\n");
    expectError
    (
        2, (folder/"notHere").string(), [&] { dictionary::fromFile(a); }, a
    );
    const std::string b = write("b", "#includeIfPresent \"notHere\"\nx 1;");
    EXPECT_EQ(dictionary::fromFile(b).valueText("x"), "1");
}

TEST_F(DictionaryIncludes, ofThemselvesAreRefused)
{
    const std::string a = write("a", "#include \"a\"\n");
    expectError(1, "includes itself", [&] { dictionary::fromFile(a); }, a);
}

TEST_F(DictionaryIncludes, keepTheirHeadersToThemselves)
{
    write("b", "FoamFile { object b; } x 1;");
    const auto dict = dictionary::fromFile
    (
        write("a", "FoamFile { object a; }\n#include \"b\"\n")
    );
    EXPECT_EQ(dict.valueText("FoamFile.object"), "a");
    EXPECT_EQ(dict.valueText("x"), "1");
}

TEST_F(DictionaryIncludes, comeFromTheEtcFolder)
{
    const std::string a = write("a", "#includeEtc \"caseDicts/b\"\n");
    write("etc/caseDicts/b", "b 1;");
    write("other/caseDicts/b", "b 2;");
    setenv("SPH_PROJECT_DIR", folder.c_str(), 1);
    unsetenv("SPH_ETC");
    EXPECT_EQ(dictionary::fromFile(a).valueText("b"), "1");
    setenv("SPH_ETC", (folder/"other").c_str(), 1);
    EXPECT_EQ(dictionary::fromFile(a).valueText("b"), "2");
    setenv("SPH_ETC", (folder/"nowhere").c_str(), 1);
    expectError
    (
        1, "nowhere/caseDicts/b", [&] { dictionary::fromFile(a); }, a
    );
    unsetenv("SPH_ETC");
    unsetenv("SPH_PROJECT_DIR");
}

TEST_F(DictionaryIncludes, folderIsNoFile)
{
    const std::string path = folder.string();
    expectError(0, "cannot read", [&] { dictionary::fromFile(path); }, path);
    const std::string none = path + "/none";
    expectError(0, "cannot find", [&] { dictionary::fromFile(none); }, none);
}
