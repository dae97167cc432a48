// Spoilt dictionaries are read, or refused with an Error.
#include "fuzz/Fuzz.H"
#include "fuzz/targets.H"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

namespace sph
{

namespace fs = std::filesystem;

// All dictionaries of tutorials and of the tests of the grammar
static wordList dictionaryFiles()
{
    const fs::path root = SPH_PROJECT_ROOT;
    wordList files;
    for
    (
        const fs::path& folder :
        {root/"tutorials", root/"etc"/"caseDicts", fs::path(SPH_TEST_DATA)}
    )
    {
        for (const auto& entry : fs::recursive_directory_iterator(folder))
        {
            const fs::path path = entry.path();
            const std::string parent = path.parent_path().filename().string();
            const bool isDict =
                path.extension() == ".dict" || parent == "constant"
             || parent == "system" || parent == "paperAsWritten";
            if (entry.is_regular_file() && isDict)
            {
                files.push_back(path.string());
            }
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

TEST(fuzz, dictionaries)
{
    const wordList files = dictionaryFiles();
    Fuzz fuzz;
    for (const word& file : files)
    {
        std::ifstream is(file, std::ios::binary);
        fuzz.corpus.push_back({std::istreambuf_iterator<char>(is), {}});
    }
    fuzz.words =
    {
        "{", "}", "(", ")", "[", "]", ";", "\"", "\\", "#{", "#}", "/*", "*/",
        "//", "\n", "$", "${", "$:", "$..", "$a", "${a:-1}", "a { ", "a ( ",
        "a $b;\n", "#include \"", "#includeEtc \"", "#eval{ ", "#eval{ (",
        "#calc \"", "#if yes\n", "#if no\n", "#ifeq a b\n", "#else\n",
        "#endif\n", "#remove ", "#inputMode ", "\"a.*\" ", "\".*\" {",
        "\"(a*)*b\" 1;\n", "\"((((", "a.a.a.a", "10{ 1 }", "2147483647{ 1 }",
        "List<scalar> 3(", "nonuniform", "uniform", "[m s^-1]", "[0 1 -2]",
        "sqrt(", "vector(", "-", "!", "?", ":", "%", "&&", "x1 $x0 $x0;\n",
        "FoamFile", "yes", "\xEF\xBB\xBF", "\r\n"
    };
    fuzz.target = [&](const std::string& input, const std::size_t source)
    {
        readAnyDictionary(input, files[source]);
    };
    fuzz.run("dictionaries", 3000);
}

} // namespace sph
