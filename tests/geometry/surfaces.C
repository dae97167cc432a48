// Walls from surfaces in space, cut at a plane: the same as those whose points
// are typed. Coordinates are multiples of 1/64, exact in single precision too.
#include "GeometryCase.H"

#include <cmath>

using namespace sph;

namespace
{

const std::vector<vector> ramp
{
    {0, 1}, {0.5, 1}, {1.25, 0.25}, {3, 0.125}
};
const std::vector<vector> box{{0, 0}, {2, 0}, {2, 1}, {0, 1}, {0, 0}};

std::vector<vector> reversed(std::vector<vector> line)
{
    std::reverse(line.begin(), line.end());
    return line;
}

// Points, and cells of some kind, in VTK's legacy format
std::string vtk
(
    const std::string& kind, const std::vector<Eigen::Vector3d>& points,
    const std::vector<std::vector<label>>& cells
)
{
    std::ostringstream os;
    os.precision(17);
    os
        << "# vtk DataFile Version 3.0\ntest\nASCII\nDATASET POLYDATA\nPOINTS "
        << points.size() << " double\n";
    for (const Eigen::Vector3d& r : points)
    {
        os << r.transpose() << '\n';
    }
    std::size_t size = 0;
    for (const auto& cell : cells)
    {
        size += cell.size() + 1;
    }
    os << kind << ' ' << cells.size() << ' ' << size << '\n';
    for (const auto& cell : cells)
    {
        os << cell.size();
        for (const label i : cell)
        {
            os << ' ' << i;
        }
        os << '\n';
    }
    return os.str();
}

std::string vtk(const std::vector<Triangle>& triangles)
{
    std::vector<Eigen::Vector3d> points;
    std::vector<std::vector<label>> cells;
    for (const Triangle& triangle : triangles)
    {
        const label n = label(points.size());
        points.insert(points.end(), triangle.begin(), triangle.end());
        cells.push_back({n, n + 1, n + 2});
    }
    return vtk("POLYGONS", points, cells);
}

std::string vtp(const std::vector<Triangle>& triangles)
{
    std::ostringstream points, ids, ends;
    points.precision(17);
    label n = 0;
    for (const Triangle& triangle : triangles)
    {
        for (const Eigen::Vector3d& r : triangle)
        {
            points << r.transpose() << '\n';
            ids << n++ << ' ';
        }
        ends << n << ' ';
    }
    return
        "<VTKFile type=\"PolyData\" version=\"0.1\""
        " byte_order=\"LittleEndian\">\n<PolyData>\n<Piece NumberOfPoints=\""
      + std::to_string(n) + "\" NumberOfPolys=\""
      + std::to_string(triangles.size())
      + "\">\n<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\""
        " format=\"ascii\">" + points.str() + "</DataArray></Points>\n"
        "<Polys><DataArray type=\"Int32\" Name=\"connectivity\""
        " format=\"ascii\">" + ids.str() + "</DataArray>\n"
        "<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">"
      + ends.str() + "</DataArray></Polys>\n</Piece>\n</PolyData>\n</VTKFile>";
}

} // namespace


TEST(geometrySurface, isTheSameAsPointsTyped)
{
    const GeometryCase where;
    const auto triangles = extruded(ramp);
    where.geometry("ramp.stl", asciiStl(triangles));
    where.geometry("binary.STL", binaryStl(triangles));
    where.geometry("ramp.vtk", vtk(triangles));
    where.geometry("ramp.vtp", vtp(triangles));
    const auto expected = where.wall(typed(ramp));
    for (const char* name : {"ramp.stl", "binary.STL", "ramp.vtk", "ramp.vtp"})
    {
        SCOPED_TRACE(name);
        expectSame(where.wallOf(name), expected);
    }
}

TEST(geometrySurface, needsThePointsOfItsCells)
{
    const GeometryCase where;
    const auto triangles = extruded(ramp);
    std::string text = vtp(triangles);
    const auto end = text.find(" </DataArray>", text.find("connectivity"));
    const auto last = text.rfind(' ', end - 1) + 1;
    for (const char* id : {"99999", "-7"})
    {
        std::string broken = text;
        where.geometry("ramp.vtp", broken.replace(last, end - last, id));
        EXPECT_CONTAINS
        (
            where.error("ramp.vtp"), "A cell has points that are not there"
        );
    }
}

// Solids of several parts, as OpenFOAM's users have them
TEST(geometrySurface, mayBeOfSeveralSolids)
{
    const GeometryCase where;
    const std::vector<vector> upper(ramp.begin(), ramp.begin() + 3);
    const std::vector<vector> lower(ramp.begin() + 2, ramp.end());
    where.geometry
    (
        "ramp.stl", asciiStl(extruded(upper)) + asciiStl(extruded(lower))
    );
    expectSame(where.wallOf("ramp.stl"), where.wall(typed(ramp)));
}

// The order of triangles means nothing, their normals say where material is
TEST(geometrySurface, hasTheMaterialWhereItsNormalsPoint)
{
    const GeometryCase where;
    for (const auto& line : {ramp, reversed(ramp)})
    {
        auto triangles = extruded(line);
        std::rotate(triangles.begin(), triangles.begin() + 3, triangles.end());
        where.geometry("ramp.stl", asciiStl(triangles));
        expectSame(where.wallOf("ramp.stl"), where.wall(typed(line)));
        expectSame
        (
            where.wallOf("ramp.stl", "flip yes;"),
            where.wall(typed(reversed(line)))
        );
    }
}

TEST(geometrySurface, ofABoxIsClosedEitherWay)
{
    const GeometryCase where;
    where.geometry("in.stl", asciiStl(extruded(box)));
    where.geometry("out.stl", asciiStl(extruded(reversed(box))));
    expectSame(where.wallOf("in.stl"), where.wall(typed(box)));
    expectSame(where.wallOf("out.stl"), where.wall(typed(reversed(box))));
}

// A round obstacle: facets meet the plane wherever their diagonals do, and
// leave no trace there
TEST(geometrySurface, ofAPrismHasItsCornersAndNoMore)
{
    std::vector<vector> prism;
    for (label k = 0; k <= 12; ++k)
    {
        const scalar angle = -2*M_PI*(k % 12)/12 + M_PI;
        prism.push_back(vector(std::cos(angle), std::sin(angle)));
    }
    const GeometryCase where;
    where.geometry("prism.vtk", vtk(extruded(prism, -0.3, 0.7)));
    expectSame(where.wallOf("prism.vtk"), where.wall(typed(prism)), 1e-12);
}

// Terrain with z upwards, cut along x at y = 5
TEST(geometrySurface, isCutAtAnyPlane)
{
    auto triangles = extruded(ramp, 4, 6);
    for (Triangle& triangle : triangles)
    {
        for (Eigen::Vector3d& r : triangle)
        {
            r = Eigen::Vector3d(r.x(), r.z(), r.y());
        }
        std::swap(triangle[0], triangle[1]);    // it was mirrored
    }
    const GeometryCase where;
    where.geometry("terrain.stl", asciiStl(triangles));
    expectSame
    (
        where.wallOf
        (
            "terrain.stl", "plane { origin (0 5 0); normal (0 -1 0); }"
        ),
        where.wall(typed(ramp))
    );
    // Seen from behind, with another origin: x runs the other way
    std::vector<vector> mirrored;
    for (const vector& r : reversed(ramp))
    {
        mirrored.emplace_back(3 - r.x(), r.y());
    }
    expectSame
    (
        where.wallOf
        (
            "terrain.stl",
            "plane { origin (3 5 0); normal (0 2 0); e1 (-1 0.5 0); }"
        ),
        where.wall(typed(mirrored))
    );
}

TEST(geometrySurface, chosenByNumberTheLongestIsTheFirst)
{
    const GeometryCase where;
    std::vector<vector> small;
    for (const vector& r : reversed(box))
    {
        small.push_back(0.5*r + vector(4, 2));
    }
    where.geometry
    (
        "two.stl", asciiStl(extruded(small)) + asciiStl(extruded(ramp))
    );
    expectSame(where.wallOf("two.stl", "line 1;"), where.wall(typed(ramp)));
    expectSame(where.wallOf("two.stl", "line 2;"), where.wall(typed(small)));

    const std::string error = where.error("two.stl");
    EXPECT_CONTAINS(error, "Which line of");
    EXPECT_CONTAINS(error, "line <number>;");
    EXPECT_CONTAINS(error, "1  7 points, open, from (0 1 0) to (3 0.125 0)");
    EXPECT_CONTAINS(error, "2  9 points, closed, from (4 2 0) to (4 2 0)");
    EXPECT_CONTAINS(where.error("two.stl", "line 3;"), "no such line");
    EXPECT_CONTAINS(where.error("two.stl", "line 0;"), "no such line");
}

// Facets that disagree: most of them decide, and a warning says so
TEST(geometrySurface, withMixedNormalsIsWarnedOf)
{
    const GeometryCase where;
    auto triangles = extruded(ramp);
    std::swap(triangles[0][0], triangles[0][1]);
    where.geometry("ramp.stl", asciiStl(triangles));
    testing::internal::CaptureStderr();
    {
        const auto dict = dictionary::fromString
        (
            "bed { type noSlip; geometry { file \""
          + (where.dir()/"constant/geometry/ramp.stl").string() + "\"; } }"
        );
        testing::internal::CaptureStdout();
        const Boundaries boundaries(dict, 0.1);
        testing::internal::GetCapturedStdout();
        EXPECT_GT(boundaries.distance({1.25, 0.5}).first, 0);
    }
    EXPECT_CONTAINS
    (
        testing::internal::GetCapturedStderr(), "disagree about the side"
    );
}

// Lines that are drawn as such are not cut
TEST(geometrySurface, mayBeLinesThemselves)
{
    std::vector<Eigen::Vector3d> points;
    for (const vector& r : ramp)
    {
        points.emplace_back(r.x(), r.y(), 7);
    }
    const GeometryCase where;
    where.geometry("ramp.vtk", vtk("LINES", points, {{0, 1, 2, 3}}));
    expectSame(where.wallOf("ramp.vtk"), where.wall(typed(ramp)));
}
