// Regions from the same files as walls.
#include "GeometryCase.H"
#include "regions/Region.H"

using namespace sph;

namespace
{

const std::vector<vector> hill
{
    {0, 0}, {3, 0}, {3, 0.25}, {1.5, 1}, {0.5, 0.5}
};

std::vector<vector> closed(std::vector<vector> line)
{
    line.push_back(line.front());
    return line;
}

struct RegionFiles : testing::Test
{
    GeometryCase where;

    std::unique_ptr<Region> region(const std::string& text) const
    {
        const Silence silence;
        where.write("system/setParticlesDict", text);
        return Region::New
        (
            dictionary::fromFile(where.dir()/"system"/"setParticlesDict")
        );
    }
    std::string of(const std::string& name) const
    {
        return
            "type polygon; geometry { file \"constant/geometry/" + name
          + "\"; }";
    }
    std::string error(const std::string& name) const
    {
        return errorOf([&]() { region(of(name)); });
    }
};

void expectSameInside(const Region& a, const Region& b)
{
    EXPECT_DOUBLE_EQ(a.area(), b.area());
    EXPECT_EQ(a.bounds().min(), b.bounds().min());
    EXPECT_EQ(a.bounds().max(), b.bounds().max());
    for (scalar x = -0.1; x < 3.2; x += 0.07)
    {
        for (scalar y = -0.1; y < 1.2; y += 0.07)
        {
            EXPECT_EQ(a.inside({x, y}), b.inside({x, y})) << x << ' ' << y;
        }
    }
}

} // namespace


// The first corner may be repeated or not
TEST_F(RegionFiles, areTheSameAsPointsTyped)
{
    where.geometry("open.csv", columns(hill));
    where.geometry("closed.csv", columns(closed(hill)));
    where.geometry("hill.stl", asciiStl(extruded(closed(hill))));
    const auto expected = region("type polygon; " + typed(hill));
    for (const char* name : {"open.csv", "closed.csv", "hill.stl"})
    {
        SCOPED_TRACE(name);
        expectSameInside(*region(of(name)), *expected);
    }
}

// A fine outline keeps all of its points
TEST_F(RegionFiles, areNotSimplified)
{
    std::vector<vector> circle;
    for (label k = 0; k < 2000; ++k)
    {
        const scalar angle = 2*M_PI*k/2000;
        circle.emplace_back(std::cos(angle), std::sin(angle));
    }
    where.geometry("circle.csv", columns(circle));
    EXPECT_NEAR
    (
        region(of("circle.csv"))->area(), 1000*std::sin(2*M_PI/2000), 1e-12
    );
}

TEST_F(RegionFiles, makeHoles)
{
    where.geometry("hill.stl", asciiStl(extruded(closed(hill))));
    const auto above = region
    (
        "type difference; regions ( air { type box; min (0 0 0); max (3 1 0); }"
        " ground { " + of("hill.stl") + " } );"
    );
    EXPECT_NEAR(above->area(), 3 - region(of("hill.stl"))->area(), 1e-3);
    EXPECT_TRUE(above->inside({0.2, 0.5}));
    EXPECT_FALSE(above->inside({1.5, 0.5}));
}

TEST_F(RegionFiles, withAGapOrTooFewPointsAreRefused)
{
    where.geometry("gap.stl", asciiStl(extruded(hill)));
    EXPECT_CONTAINS
    (
        error("gap.stl"), "The outline is open, from (0 0 0) to (0.5 0.5 0)"
    );
    where.geometry("two.csv", "0,0\n1,0\n");
    EXPECT_CONTAINS(error("two.csv"), "at least 3 points, not 2");
    where.geometry("eight.csv", "0,0\n1,1\n1,0\n0,1\n");
    EXPECT_CONTAINS(error("eight.csv"), "The polygon intersects itself");
    EXPECT_CONTAINS(error("eight.csv"), "eight.csv at line 1.");
}
