// Walls from columns of numbers: the same as those whose points are typed.
#include "GeometryCase.H"

#include <cmath>

using namespace sph;

namespace
{

// A slope with corners of both kinds; none of the numbers is a round one
const std::vector<vector> slope
{
    {-0.3, 1.1}, {0.7/3, 0.9}, {0.81, 0.31}, {1.77, 0.29/3}, {2.9, 0.13}
};

std::vector<vector> reversed(std::vector<vector> line)
{
    std::reverse(line.begin(), line.end());
    return line;
}

} // namespace


TEST(geometryCsv, isTheSameAsPointsTyped)
{
    const GeometryCase where;
    where.geometry("bed.csv", columns(slope));
    expectSame(where.wallOf("bed.csv"), where.wall(typed(slope)));
}

TEST(geometryCsv, isFoundFromTheCaseWhereverItsDictionaryStands)
{
    const GeometryCase where;
    where.geometry("bed.csv", columns(slope));
    where.write
    (
        "constant/more/walls",
        "geometry { file \"constant/geometry/bed.csv\"; }"
    );
    expectSame
    (
        where.wall("#include \"more/walls\""), where.wall(typed(slope))
    );
}

TEST(geometryCsv, takesColumnsByTheirNames)
{
    const GeometryCase where;
    where.geometry
    (
        "bed.csv",
        "\xEF\xBB\xBF# survey\r\nstation;\"z [m]\"; x\r\n1;0.5;0\r\n"
        "2;0;+1\r\n# end\r\n"
    );
    expectSame
    (
        where.wallOf("bed.csv", "columns (x \"z [m]\");"),
        where.wall(typed({{0, 0.5}, {1, 0}}))
    );
    where.geometry("plain.dat", "0 7 0.5\n1 8 0\n");
    expectSame
    (
        where.wallOf("plain.dat", "format csv; columns (x z);"),
        where.wall(typed({{0, 0.5}, {1, 0}}))
    );
}

TEST(geometryCsv, isScaledThenTurnedThenMoved)
{
    const GeometryCase where;
    where.geometry("bed.csv", "0,0\n1000,0\n");
    const scalar c = std::cos(M_PI/6), s = std::sin(M_PI/6);
    expectSame
    (
        where.wallOf
        (
            "bed.csv", "scale 0.001; rotate 30; translate (2 3 0);"
        ),
        where.wall(typed({{2, 3}, {2 + c, 3 + s}})), 1e-14
    );
}

TEST(geometryCsv, flippedHasTheMaterialOnTheOtherSide)
{
    const GeometryCase where;
    where.geometry("bed.csv", columns(reversed(slope)));
    expectSame
    (
        where.wallOf("bed.csv", "flip yes;"), where.wall(typed(slope))
    );
}

// A closed line: material in it, or around it
TEST(geometryCsv, mayBeClosed)
{
    const std::vector<vector> box{{0, 0}, {2, 0}, {2, 1}, {0, 1}, {0, 0}};
    const GeometryCase where;
    where.geometry("box.csv", columns(box));
    const auto inside = where.wallOf("box.csv");
    const auto outside = where.wallOf("box.csv", "flip yes;");
    expectSame(inside, where.wall(typed(box)));
    for (const WallParticle& w : inside)
    {
        EXPECT_TRUE(w.r.x() < 0 || w.r.x() > 2 || w.r.y() < 0 || w.r.y() > 1);
    }
    for (const WallParticle& w : outside)
    {
        EXPECT_TRUE(w.r.x() > 0 && w.r.x() < 2 && w.r.y() > 0 && w.r.y() < 1);
    }
}

// No side below dx unless asked for
TEST(geometryCsv, finerThanTheParticlesIsSimplified)
{
    std::vector<vector> arc;
    for (label k = 0; k <= 400; ++k)
    {
        arc.push_back(2*vector(std::sin(k*0.002), 1 - std::cos(k*0.002)));
    }
    const GeometryCase where;
    where.geometry("arc.csv", columns(arc));
    const auto walls = where.wallOf("arc.csv");
    // As a circle would have them: from each row of depth d an arc of R + d
    EXPECT_NEAR(walls.size(), 0.8*(2.05 + 2.15 + 2.25)/0.1, 1.5);
    for (const WallParticle& w : walls)
    {
        EXPECT_NEAR((w.r - vector(0, 2)).norm(), 2 + w.depth, 2e-3);
    }
    expectSame
    (
        where.wallOf("arc.csv", "shortest 0;"), where.wall(typed(arc))
    );
}
