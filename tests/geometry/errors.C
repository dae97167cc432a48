// Files that no wall can be made of: what is wrong, and where.
#include "GeometryCase.H"

using namespace sph;

namespace
{

// The block names the file, and the line if it is not 0
void expectPlace
(
    const GeometryCase& where, const std::string& block,
    const std::string& file, const label line
)
{
    EXPECT_CONTAINS
    (
        block,
        "file: " + (where.dir()/file).string()
      + (line > 0 ? " at line " + std::to_string(line) + "." : "\n")
    );
}

// Of a file bed.csv with this text
void expectCsvError
(
    const std::string& text, const std::string& message, const label line = 0
)
{
    const GeometryCase where;
    where.geometry("bed.csv", text);
    const std::string block = where.error("bed.csv");
    EXPECT_CONTAINS(block, message);
    expectPlace(where, block, "constant/geometry/bed.csv", line);
}

// Of the entries of the dictionary geometry, whose first is on line 5
void expectEntryError
(
    const std::string& entries, const std::string& message, const label line
)
{
    const GeometryCase where;
    where.geometry("bed.csv", "0,0\n1,0\n");
    where.geometry("bed.stl", asciiStl(extruded({{0, 0}, {1, 0}})));
    where.geometry("bed.dxf", "");
    const std::string block = errorOf
    (
        [&]() { where.wall("geometry {\n" + entries + "\n}"); }
    );
    EXPECT_CONTAINS(block, message);
    EXPECT_CONTAINS(block, (where.dir()/"constant/boundary").string());
    EXPECT_CONTAINS(block, "line " + std::to_string(line));
}

const std::string csvFile = "file \"constant/geometry/bed.csv\"; ";
const std::string stlFile = "file \"constant/geometry/bed.stl\"; ";

} // namespace


TEST(geometryErrors, ofTheEntries)
{
    expectEntryError("", "Entry 'file' not found", 4);
    expectEntryError("file \"bad.csv\";", "There is no file bad.csv", 5);
    expectEntryError("file \"bad.csv\";", "looked for\n", 5);
    expectEntryError("file \"constant\";", "There is no file constant", 5);
    expectEntryError
    (
        "file \"constant/geometry/bed.dxf\";",
        "Unknown geometryFormat type dxf\n\n"
        "Valid geometryFormat types :\n\n4\n(\ncsv\nstl\nvtk\nvtp\n)", 4
    );
    expectEntryError(csvFile + "format cvs;", "did you mean 'csv'?", 5);
    expectEntryError(csvFile + "columns (x);", "Two columns are needed", 5);
    expectEntryError(csvFile + "scale 0;", "'scale' is 0 but must be", 5);
    expectEntryError(csvFile + "shortest -1;", "'shortest' is -1", 5);
    expectEntryError(csvFile + "line 2;", "There is no such line", 5);
    expectEntryError(csvFile + "scael 2;", "did you mean 'scale'?", 5);
    expectEntryError(csvFile + "plane {}", "'plane'", 5);
    expectEntryError(csvFile + "plane {}", "is not used", 5);
    expectEntryError
    (
        stlFile + "plane { normal (0 0 0); }", "must not be zero", 5
    );
    expectEntryError
    (
        stlFile + "plane { normal (1 0 0); }", "must not be along", 5
    );
    expectEntryError
    (
        stlFile + "plane { e1 (1 0); }", "'e1' needs three numbers", 5
    );
    expectEntryError(stlFile + "plane { orign (0 0 0); }", "'origin'", 5);
}

TEST(geometryErrors, ofNoLineOrTwo)
{
    const GeometryCase where;
    where.geometry("bed.csv", "0,0\n1,0\n");
    const std::string message =
        "Either points ( ... ); or geometry { file ...; } must be given";
    EXPECT_CONTAINS(errorOf([&]() { where.wall(""); }), message);
    EXPECT_CONTAINS
    (
        errorOf
        (
            [&]()
            {
                where.wall
                (
                    typed({{0, 0}, {1, 0}}) + "geometry {" + csvFile + '}'
                );
            }
        ),
        message
    );
}

TEST(geometryErrors, ofColumns)
{
    expectCsvError("", "no row of numbers");
    expectCsvError("x,y\n", "no row of numbers");
    expectCsvError("a,b\n0,0\n1,0\n", "no column x");
    expectCsvError("a,b\n0,0\n1,0\n", "Its columns are :\n\n2\n(\na\nb\n)");
    expectCsvError("x,y\n0,0\n1\n", "Expected 2 numbers", 3);
    expectCsvError
    (
        "x,y\n0,0\n1,1.5m\n",
        "Expected a number in column y, found '1.5m'", 3
    );
    expectCsvError("0,0\n1,nan\n", "found 'nan'", 2);
    expectCsvError("0,0\n1,inf\n", "found 'inf'", 2);
    expectCsvError("x;y\n0;0\n1;0,5\n", "found '0,5'", 3);
    expectCsvError("0\n1\n", "no column y");
}

TEST(geometryErrors, ofPoints)
{
    expectCsvError("0,0\n", "at least two points");
    expectCsvError
    (
        "x,y\n0,0\n\n1,0\n0.5,0\n",
        "The wall folds back on itself at point 1, (1 0 0)", 4
    );
    expectCsvError
    (
        "x,y\n0,0\n2,0\n2,1\n# up\n1,-1\n",
        "The wall intersects itself: the side after point 0 meets the side"
        " after point 2", 2
    );
    expectCsvError
    (
        "0,0\n2,0\n2,1\n1,-1\n", "They begin at (0 0 0) and (2 1 0)", 1
    );
    // All of it shorter than dx: the wrong unit
    expectCsvError("0,0\n0.001,0\n0,0.001\n0,0\n", "are the same, (0 0 0)", 4);
}

// Typed ones are refused as well
TEST(geometryErrors, ofPointsTyped)
{
    const GeometryCase where;
    const std::string block = errorOf
    (
        [&]() { where.wall(typed({{0, 0}, {2, 0}, {2, 1}, {1, -1}})); }
    );
    EXPECT_CONTAINS(block, "The wall intersects itself");
    EXPECT_CONTAINS(block, "at line 4.");
}

TEST(geometryErrors, ofSurfaces)
{
    const GeometryCase where;
    const auto expect = [&]
    (
        const std::string& name, const std::string& text,
        const std::string& message
    )
    {
        where.geometry(name, text);
        const std::string block = where.error(name);
        EXPECT_CONTAINS(block, message);
        expectPlace(where, block, "constant/geometry/" + name, 0);
    };
    expect
    (
        "above.stl", asciiStl(extruded({{0, 0}, {1, 0}}, 0.5, 2)),
        "The plane does not cut the surface, which lies from 0.5 to 2"
    );
    expect("empty.stl", "", "The file is broken");
    expect("words.stl", "nothing of the kind\n", "The file is broken");
    const auto triangles = extruded({{0, 0}, {1, 0}, {2, 1}});
    const std::string binary = binaryStl(triangles);
    const std::string ascii = asciiStl(triangles);
    for (const std::size_t part : {30, 120, 140, 200})
    {
        expect("short.stl", binary.substr(0, part), "The file is broken");
        expect("cut.stl", ascii.substr(0, 2*part), "The file is broken");
    }
    expect("words.vtk", "nothing of the kind\n", "The file is broken");
    expect("words.vtp", "nothing of the kind\n", "The file is broken");
    expect
    (
        "points.vtk",
        "# vtk DataFile Version 3.0\ntest\nASCII\nDATASET POLYDATA\n"
        "POINTS 1 double\n0 0 0\nVERTICES 1 2\n1 0\n",
        "neither a surface nor lines"
    );
}
