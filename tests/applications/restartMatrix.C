// A restart at a written time equals no restart, bit for bit, whatever the
// models, the number of threads of either run, and the way of writing: every
// integrator with every rheology on every pair of numbers of threads, and any
// two choices of all else at least once. Models are taken from the selection
// tables: a new one needs no line here if its coefficients have defaults.
#include "applications/MatrixCase.H"

using namespace sph;

namespace
{

std::string describe(const Pairwise::Choices& row)
{
    std::string text;
    for (const auto& [factor, value] : row)
    {
        text += factor + ' ' + value + "; ";
    }
    return text;
}

const std::vector<Pairwise::Choices>& rows()
{
    static const std::vector<Pairwise::Choices> list = []
    {
        const Pairwise::Factors factors = RestartFactors::all();
        const std::map<word, wordList> values(factors.begin(), factors.end());
        std::vector<Pairwise::Choices> begun;
        for (const word& rheology : values.at("rheology"))
        {
            for (const word& integrator : values.at("integrator"))
            {
                for (const word& threads : values.at("threads"))
                {
                    begun.push_back
                    ({
                        {"rheology", rheology}, {"integrator", integrator},
                        {"threads", threads}
                    });
                }
            }
        }
        return Pairwise(factors, 2, RestartFactors::allowed, begun).rows;
    }();
    return list;
}

wordList laterTimes(const AppCase& where)
{
    wordList names;
    for (const Time::Instant& time : Time::findTimes(where.dir()))
    {
        if (time.value > 0)
        {
            names.push_back(time.name);
        }
    }
    return names;
}

void expectSameFiles
(
    const std::map<word, std::string>& whole,
    const std::map<word, std::string>& parts
)
{
    for (const auto& [file, text] : whole)
    {
        const auto found = parts.find(file);
        ASSERT_TRUE(found != parts.end()) << "no " << file;
        EXPECT_TRUE(found->second == text) << file;
    }
    EXPECT_EQ(whole.size(), parts.size());
}

// What the choices are to try does happen
void expectEvents
(
    const Pairwise::Choices& row, const MatrixCase& where,
    const Outcome& again
)
{
    const auto is = [&](const word& factor, const word& value)
    {
        return row.at(factor) == value;
    };
    EXPECT_EQ
    (
        contains(again.text, "PCG:"), is("viscousIntegration", "implicit")
    );
    EXPECT_EQ
    (
        std::regex_search(again.text, std::regex("Asleep: [1-9]")),
        is("sleep", "yes")
    );
    const word last = where.latestTime();
    EXPECT_EQ
    (
        contains(where.text(last + "/uniform/equationOfState"), "windowStart"),
        is("adaptive", "yes")
    );
    EXPECT_EQ
    (
        contains(where.text(last + "/granular.vtp"), "format=\"ascii\""),
        is("format", "ascii")
    );
}

void expectRestartIsExact(const Pairwise::Choices& row)
{
    SCOPED_TRACE(describe(row));
    const MatrixCase where(row);
    where.setParticles();
    where.go(false);
    wordList times = laterTimes(where);
    ASSERT_GE(times.size(), 3u);
    const word from = times.front();
    times.push_back("VTK");
    const auto whole = where.files(times);
    const wordList wholeRows = where.extremes("0");

    for (const word& time : laterTimes(where))
    {
        if (time != from)
        {
            where.remove(time);
        }
    }
    expectEvents(row, where, where.go(true));
    expectSameFiles(whole, where.files(times));

    // All that follows, step by step, in fields that are not written either
    const wordList rows = where.extremes(from);
    ASSERT_GT(rows.size(), 2u);
    ASSERT_GT(wholeRows.size(), rows.size());
    for (std::size_t k = 0; k < rows.size(); ++k)
    {
        const word& expected = wholeRows[wholeRows.size() - rows.size() + k];
        ASSERT_EQ(rows[k], expected) << "row " << k;
    }
}

// Parts of the matrix, to run side by side
constexpr std::size_t nParts = 4;

void expectPartIsExact(const std::size_t part)
{

    for (std::size_t k = part; k < rows().size(); k += nParts)
    {
        expectRestartIsExact(rows()[k]);
    }
}

} // namespace

TEST(restartMatrix, part0)
{
    expectPartIsExact(0);
}

TEST(restartMatrix, part1)
{
    expectPartIsExact(1);
}

TEST(restartMatrix, part2)
{
    expectPartIsExact(2);
}

TEST(restartMatrix, part3)
{
    expectPartIsExact(3);
}

// Families and boundaries that are new have to be thought of
TEST(restartMatrix, knowsEveryFamilyAndBoundary)
{
    wordList known = RestartFactors::families();
    known.insert
    (
        known.end(),
        {
            "boundary", "functionObject", "geometryFormat", "region",
            "runoutLaw"
        }
    );
    for (const auto& [family, table] : SelectionTables::all())
    {
        EXPECT_EQ(std::count(known.begin(), known.end(), family), 1)
            << family << " is not a factor in MatrixCase.H";
    }

    std::set<word> types;
    for (const auto& [name, scene] : RestartFactors::scenes())
    {
        const dictionary boundary = dictionary::fromString(scene);
        for (const word& patch : boundary.toc())
        {
            types.insert(boundary.subDict(patch).get<word>("type"));
        }
    }
    for (const auto& [type, text] : SelectionTables::all()["boundary"])
    {
        EXPECT_EQ(types.count(type), 1u)
            << type << " is in no scene of MatrixCase.H";
    }
}
