#include "io/ColumnFile.H"
#include "runTime/TestCase.H"

using namespace sph;

namespace
{

using Rows = std::vector<std::vector<scalar>>;

struct ColumnFiles : testing::Test
{
    TestCase where;

    ColumnFile file(const std::string& text) const
    {
        where.write("a.csv", text);
        return ColumnFile(where.dir()/"a.csv");
    }
    std::string error(const std::string& text, const word& name = "x") const
    {
        return errorOf([&]() { file(text).column(name); });
    }
};

} // namespace


TEST_F(ColumnFiles, haveNamedColumns)
{
    const auto table =
        file("# made up\n\nx,y\n1,2.5\n 2 , -3e-1 \n# end\n3;4\n");
    EXPECT_EQ(table.column("x"), 0);
    EXPECT_EQ(table.column("y"), 1);
    EXPECT_EQ(table.rows(), (Rows{{1, 2.5}, {2, -0.3}, {3, 4}}));
    EXPECT_EQ(table.lines(), (std::vector<label>{4, 5, 7}));

    EXPECT_EQ(file("# comment\n# a      y\n1 2\n").column("a"), 0);
}

TEST_F(ColumnFiles, ofSpreadsheets)
{
    const auto table = file
    (
        "\xEF\xBB\xBF\"station\";\"z [m]\";x\r\n1;0.5;+0.25\r\n"
    );
    EXPECT_EQ(table.column("z [m]"), 1);
    EXPECT_EQ(table.column("station"), 0);
    EXPECT_EQ(table.rows(), (Rows{{1, 0.5, 0.25}}));
}

// A comment that is none of their names does not swallow a row
TEST_F(ColumnFiles, withoutNamesHaveThoseOfCoordinates)
{
    for (const char* head : {"", "# a profile\n"})
    {
        const auto table = file(head + std::string("0 1 2 3\n4 5 6 7\n"));
        EXPECT_EQ(table.rows().size(), 2u);
        EXPECT_EQ(table.column("y"), 1);
        EXPECT_EQ(table.column("z"), 2);
        EXPECT_EQ(table.column("4"), 3);
    }
}

TEST_F(ColumnFiles, sayWhatIsWrong)
{
    EXPECT_CONTAINS(error("x,y\n1,2\n", "u"), "no column u");
    EXPECT_CONTAINS(error("u,y\n1,2\n3\n"), "line 3");
    EXPECT_CONTAINS(error("u,y\n1,2\n3\n"), "Expected 2 numbers");
    EXPECT_CONTAINS(error("u,y\n1,2\n3,z\n"), "column y, found 'z'");
    EXPECT_CONTAINS(error("u,y\n1,2\n3,z\n"), "line 3");
    EXPECT_CONTAINS(error("u,y\n1,,2\n"), "found 3");
    EXPECT_CONTAINS(error("u,y\n1,\n"), "found 1");
    EXPECT_CONTAINS(error("u,y\n1,1e999\n"), "found '1e999'");
    EXPECT_CONTAINS(error("u,y\n"), "no row");
    EXPECT_EQ(error("x,y\n1,2\n"), "");
    EXPECT_THROW(ColumnFile(where.dir()/"none.csv"), IOError);
    EXPECT_THROW(ColumnFile(where.dir()), IOError);
}
