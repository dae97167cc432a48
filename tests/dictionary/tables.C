// Every row of the tables that record what OpenFOAM makes of a dictionary.

#include "dictionary/dictionary.H"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace fs = std::filesystem;
using namespace sph;

namespace
{

const fs::path folder = fs::path(SPH_TEST_DATA)/"foam-dictionary";

std::string unescaped(const std::string& text)
{
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i)
    {
        if (text[i] == '\\' && i + 1 < text.size())
        {
            const char c = text[++i];
            result += c == 'n' ? '\n' : c == 't' ? '\t' : c;
        }
        else
        {
            result += text[i];
        }
    }
    return result;
}

std::vector<wordList> rows(const std::string& file, const std::size_t columns)
{
    std::ifstream is(folder/file);
    std::vector<wordList> table;
    std::string line;
    std::getline(is, line);
    while (std::getline(is, line))
    {
        wordList row;
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, '\t'); )
        {
            row.push_back(unescaped(cell));
        }
        row.resize(columns);
        table.push_back(row);
    }
    return table;
}

// Split at blanks and brackets, brackets being tokens of their own
wordList split(const std::string& text)
{
    std::string spaced;
    for (const char c : text)
    {
        const bool bracket = std::string("()[]{}").find(c) != std::string::npos;
        spaced += bracket ? std::string{' ', c, ' '} : std::string(1, c);
    }
    std::istringstream is(spaced);
    wordList tokens;
    for (std::string token; is >> token; )
    {
        tokens.push_back(token);
    }
    return tokens;
}

bool same(const std::string& a, const std::string& b)
{
    char* endA = nullptr;
    char* endB = nullptr;
    const scalar x = std::strtod(a.c_str(), &endA);
    const scalar y = std::strtod(b.c_str(), &endB);
    const bool numbers = !a.empty() && !b.empty() && !*endA && !*endB;
    return numbers ? std::abs(x - y) <= 1e-5*std::abs(y) : a == b;
}

void expectSame(const std::string& actual, const std::string& expected)
{
    const wordList a = split(actual);
    const wordList b = split(expected);
    ASSERT_EQ(a.size(), b.size()) << actual << "\nexpected " << expected;
    for (std::size_t i = 0; i < a.size(); ++i)
    {
        EXPECT_TRUE(same(a[i], b[i])) << actual << "\nexpected " << expected;
    }
}

// What a message about each file that does not read must name
const std::map<std::string, std::string> textAtFault
{
    {"e01-undefined-macro", "rhoo"},
    {"e02-missing-semicolon-at-end", "'b'"},
    {"e03-unbalanced-list", "points"},
    {"e04-extra-closing-paren", "point"},
    {"e05-extra-brace", "}"},
    {"e06-unclosed-dictionary", "'a'"},
    {"e07-unterminated-string", "no end"},
    {"e08-missing-include", "include/notHere"},
    {"e09-unknown-directive", "inlcude"},
    {"e10-duplicate-refused", "duplicate entry: a"},
    {"e11-above-root", "...a"},
    {"e12-bad-switch", "maybe"},
    {"e13-upper-case-switch", "TRUE"},
    {"e15-bad-number", "1.2.3"},
    {"e16-bad-expression", "2*(1 +"}
};

struct DictionaryTables : testing::Test
{
    DictionaryTables()
    {
        setenv("SPH_DEMO_SIZE", "12", 1);
        setenv("SPH_DEMO_NAME", "silo", 1);
        setenv("SPH_ETC", (folder/"etc").c_str(), 1);
    }

    ~DictionaryTables() override
    {
        unsetenv("SPH_DEMO_SIZE");
        unsetenv("SPH_DEMO_NAME");
        unsetenv("SPH_ETC");
    }
};

void checkError
(
    const fs::path& file, const std::string& name, const std::string& line
)
{
    try
    {
        dictionary::fromFile(file);
        FAIL() << "reads, but must not";
    }
    catch (const IOError& error)
    {
        EXPECT_EQ(error.file().find(file.string()), 0u) << error.block();
        EXPECT_EQ(std::to_string(error.startLine()), line) << error.block();
        ASSERT_TRUE(textAtFault.count(name)) << error.block();
        const std::string text = textAtFault.at(name);
        EXPECT_NE(error.block().find(text), std::string::npos)
            << error.block();
    }
}

std::string vectorText(const vector& value)
{
    std::ostringstream os;
    os << '(' << value.x() << ' ' << value.y() << " 0)";
    return os.str();
}

// What a reader of the wanted type makes of the entry "key"
std::string typedValue(const dictionary& dict, const std::string& wanted)
{
    std::ostringstream os;
    if (wanted == "scalar")
    {
        os << dict.get<scalar>("key");
    }
    else if (wanted == "label")
    {
        os << dict.get<label>("key");
    }
    else if (wanted == "vector")
    {
        os << vectorText(dict.get<vector>("key"));
    }
    else if (wanted == "m^2/s")
    {
        os << dict.get("key", dimKinematicViscosity);
    }
    else if (wanted == "Switch")
    {
        os << (dict.get<bool>("key") ? "true" : "false");
    }
    else if (wanted == "enumeration")
    {
        os << dict.getChoice
        (
            "key", {"endTime", "noWriteNow", "writeNow", "nextWrite"}
        );
    }
    else if (wanted == "model name")
    {
        os << dict.getChoice("key", {"Newtonian", "muI"});
    }
    else
    {
        throw std::logic_error("no reader for " + wanted);
    }
    return os.str();
}

} // namespace


TEST_F(DictionaryTables, everyRowOfExpected)
{
    const auto table = rows("expected.tsv", 6);
    ASSERT_EQ(table.size(), 187u);
    for (const wordList& row : table)
    {
        SCOPED_TRACE(row[0] + " " + row[1]);
        const fs::path file = folder/(row[0] + ".dict");
        if (row[2] == "error")
        {
            checkError(file, row[0], row[4]);
            continue;
        }
        const dictionary dict = dictionary::fromFile(file);
        if (row[2] == "absent")
        {
            EXPECT_THROW(dict.valueText(row[1]), IOError);
        }
        else
        {
            ASSERT_EQ(row[2], "value");
            expectSame(dict.valueText(row[1]), row[3]);
        }
    }
}

TEST(DictionaryTypedReads, everyRow)
{
    const auto table = rows("typed-reads.tsv", 4);
    ASSERT_EQ(table.size(), 48u);
    for (const wordList& row : table)
    {
        SCOPED_TRACE(row[0] + " from: " + row[1]);
        if (row[1] == "(key not there)")
        {
            const auto dict = dictionary::fromString("a 1;", "FILE");
            EXPECT_THROW(dict.get<scalar>("key"), IOError);
            continue;
        }
        if (row[1] == "(file not there)")
        {
            EXPECT_THROW(dictionary::fromFile("notThere"), IOError);
            continue;
        }
        const auto dict = dictionary::fromString
        (
            "first 1;\nkey " + row[1] + ";\nlast 2;", "FILE"
        );
        if (row[2] == "value")
        {
            EXPECT_NO_THROW
            (
                expectSame(typedValue(dict, row[0]), row[3])
            );
            continue;
        }
        try
        {
            ADD_FAILURE() << "gives " << typedValue(dict, row[0]);
        }
        catch (const IOError& error)
        {
            EXPECT_EQ(error.startLine(), 2) << error.block();
            EXPECT_EQ(error.file(), "FILE");
        }
    }
}
