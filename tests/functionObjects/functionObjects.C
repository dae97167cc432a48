#include "TestRun.H"

using namespace sph;

static std::vector<scalar> times
(
    const std::vector<std::vector<scalar>>& rows
)
{
    std::vector<scalar> list;
    for (const auto& row : rows)
    {
        list.push_back(row[0]);
    }
    return list;
}


TEST(functionObjects, executeAtStartAndAtEveryStepByDefault)
{
    TestRun run;
    run.go("a { type energies; }", 0.05);
    EXPECT_EQ(run.rows("a/0/a.dat").size(), 6u);
}


TEST(functionObjects, executeAtIntervalsAndAtTheEnd)
{
    TestRun run;
    run.go
    (
        "a { type energies; executeInterval 4; }"
        "b { type energies; executeControl runTime; executeInterval 0.03; }"
        "c { type energies; executeControl writeTime; executeInterval 2; }",
        0.23
    );
    const auto near = [](const std::vector<scalar>& a, std::vector<scalar> b)
    {
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t i = 0; i < a.size(); ++i)
        {
            EXPECT_NEAR(a[i], b[i], 1e-9);
        }
    };
    near
    (
        times(run.rows("a/0/a.dat")),
        {0, 0.04, 0.08, 0.12, 0.16, 0.2, 0.23}
    );
    near
    (
        times(run.rows("b/0/b.dat")),
        {0, 0.03, 0.06, 0.09, 0.12, 0.15, 0.18, 0.21, 0.23}
    );
    near(times(run.rows("c/0/c.dat")), {0, 0.1, 0.2, 0.23});
}


TEST(functionObjects, doNothingWhereTheyAreDisabled)
{
    TestRun run;
    run.go("a { type energies; enabled no; executeInterval 3; }", 0.05);
    EXPECT_FALSE(run.dir.has("postProcessing"));
}


TEST(functionObjects, keepTheResultsOfAnEarlierRun)
{
    TestRun run;
    run.go("a { type energies; }", 0.05);
    run.go("a { type energies; }", 0.02);
    run.go("a { type energies; }", 0.03);
    EXPECT_EQ(run.rows("a/0/a.dat").size(), 6u);
    EXPECT_EQ(run.rows("a/0_1/a.dat").size(), 3u);
    EXPECT_EQ(run.rows("a/0_2/a.dat").size(), 4u);
}


TEST(functionObjects, refuseUnknownTypesAndEntries)
{
    const auto error = [](const std::string& functions)
    {
        TestRun run;
        return errorOf([&]{ run.go(functions, 0.01); });
    };
    const std::string unknown = error("a { type runouts; }");
    EXPECT_CONTAINS(unknown, "runouts");
    EXPECT_CONTAINS(unknown, "stopWhenAtRest");

    EXPECT_CONTAINS
    (
        error("a { type energies; executeIntervall 2; }"), "executeInterval"
    );
    EXPECT_CONTAINS
    (
        error("a { type energies; executeInterval 0; }"), "at least 1"
    );
    EXPECT_CONTAINS
    (
        error("a { type energies; executeControl often; }"), "timeStep"
    );
    EXPECT_CONTAINS
    (
        error("a { type fieldMinMax; fields (U pressure); }"), "gammaDot"
    );
    EXPECT_CONTAINS(error("a { type image; field speed; }"), "gammaDot");
}


TEST(functionObjects, sayWhereTheyCannotWrite)
{
    TestRun run;
    run.dir.write("postProcessing", "a file where a folder has to be");
    EXPECT_CONTAINS
    (
        errorOf([&]{ run.go("a { type energies; }", 0.01); }),
        "postProcessing/a/0"
    );
}
