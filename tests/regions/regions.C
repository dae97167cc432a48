#include "regions/Region.H"
#include "setup/Lattice.H"

#include <gtest/gtest.h>

using namespace sph;

namespace
{

std::unique_ptr<Region> region(const std::string& text)
{
    return Region::New(dictionary::fromString(text, "setParticlesDict"));
}

// Area by counting lattice points
scalar counted(const Region& shape, const scalar dx)
{
    const Lattice lattice
    (
        dictionary::fromString("spacing " + std::to_string(dx) + ";")
    );
    return lattice.points(shape).size()*dx*dx;
}

const std::string boxText = "type box; min (1 2 0); max (3 5 0);";
const std::string circleText = "type circle; centre (1 2 0); radius 0.5;";
const std::string concaveText =
    "type polygon; points ((0 0 0) (2 0 0) (2 2 0) (1 0.5 0) (0 2 0));";

} // namespace


TEST(Box, holdsWhatLiesBetweenItsCorners)
{
    const auto box = region(boxText);
    EXPECT_TRUE(box->inside({1.01, 2.01}));
    EXPECT_TRUE(box->inside({2.99, 4.99}));
    EXPECT_FALSE(box->inside({0.99, 3}));
    EXPECT_FALSE(box->inside({3.01, 3}));
    EXPECT_FALSE(box->inside({2, 1.99}));
    EXPECT_FALSE(box->inside({2, 5.01}));
    EXPECT_DOUBLE_EQ(box->area(), 6);
    EXPECT_EQ(box->bounds().min(), vector(1, 2));
    EXPECT_EQ(box->bounds().max(), vector(3, 5));
}

TEST(Box, adjoiningBoxesShareNoBorderPoint)
{
    const auto left = region("type box; min (0 0 0); max (1 1 0);");
    const auto right = region("type box; min (1 0 0); max (2 1 0);");
    for (const scalar x : {1 - 1e-12, 1.0, 1 + 1e-12})
    {
        EXPECT_FALSE(left->owns({x, 0.5}, 1e-9));
        EXPECT_TRUE(right->owns({x, 0.5}, 1e-9));
    }
}

TEST(Circle, holdsWhatIsWithinItsRadius)
{
    const auto circle = region(circleText);
    EXPECT_TRUE(circle->inside({1, 2}));
    EXPECT_TRUE(circle->inside({1.35, 2.35}));
    EXPECT_FALSE(circle->inside({1.36, 2.36}));
    EXPECT_NEAR(circle->area(), pi*0.25, 1e-12);
}

TEST(Circle, crossingsAreOnTheCircle)
{
    const auto circle = region(circleText);
    const vector origin(-1, 1.8), direction(2, 0.1);
    std::vector<scalar> t;
    circle->crossings(origin, direction, t);
    ASSERT_EQ(t.size(), 2u);
    for (const scalar x : t)
    {
        EXPECT_NEAR((origin + x*direction - vector(1, 2)).norm(), 0.5, 1e-12);
    }
    t.clear();
    circle->crossings({-1, 2.6}, {1, 0}, t);
    EXPECT_TRUE(t.empty());
}

TEST(Polygon, concavePolygonHasANotch)
{
    const auto polygon = region(concaveText);
    EXPECT_TRUE(polygon->inside({1, 0.4}));
    EXPECT_FALSE(polygon->inside({1, 0.6}));
    EXPECT_TRUE(polygon->inside({0.1, 1.5}));
    EXPECT_TRUE(polygon->inside({1.9, 1.5}));
    EXPECT_FALSE(polygon->inside({2.1, 1.5}));

    // Shoelace: 4 less the notch of base 2 and height 1.5
    EXPECT_NEAR(polygon->area(), 2.5, 1e-12);
}

TEST(Polygon, eitherWayRoundIsTheSame)
{
    const auto there = region
    (
        "type polygon; points ((0 0 0) (2 0 0) (1 3 0));"
    );
    const auto back = region
    (
        "type polygon; points ((1 3 0) (2 0 0) (0 0 0));"
    );
    EXPECT_NEAR(there->area(), 3, 1e-6);
    EXPECT_NEAR(back->area(), 3, 1e-6);
    EXPECT_TRUE(there->inside({1, 1}));
    EXPECT_TRUE(back->inside({1, 1}));
}

TEST(Polygon, latticeCountConvergesToTheArea)
{
    const auto polygon = region
    (
        "type polygon;"
        "points ((0 0 0) (1.3 0.1 0) (0.9 0.45 0) (1.1 1.2 0) (0.2 0.7 0));"
    );
    const std::vector<vector> p
    {
        {0, 0}, {1.3, 0.1}, {0.9, 0.45}, {1.1, 1.2}, {0.2, 0.7}
    };
    scalar shoelace = 0;
    for (std::size_t i = 0; i < p.size(); ++i)
    {
        const vector& q = p[(i + 1) % p.size()];
        shoelace += 0.5*(p[i].x()*q.y() - p[i].y()*q.x());
    }
    EXPECT_NEAR(polygon->area(), shoelace, 1e-12);
    EXPECT_NEAR(polygon->Region::area(), shoelace, 1e-4*shoelace);
    EXPECT_NEAR(counted(*polygon, 0.1), shoelace, 0.1*shoelace);
    EXPECT_NEAR(counted(*polygon, 0.02), shoelace, 0.01*shoelace);
    EXPECT_NEAR(counted(*polygon, 0.004), shoelace, 0.001*shoelace);
}

TEST(RotatedBox, equalsTheBoxThatIsRotatedBack)
{
    // By the angle of a 3-4-5 triangle
    const auto rotated = region
    (
        "type rotatedBox; origin (1 1 0); i (1.6 1.2 0); j (-0.6 0.8 0);"
    );
    const tensor R = (tensor() << 0.8, -0.6, 0.6, 0.8).finished();
    for (scalar x = -0.55; x < 2.5; x += 0.1)
    {
        for (scalar y = -0.55; y < 1.5; y += 0.1)
        {
            const bool expected = x > 0 && x < 2 && y > 0 && y < 1;
            EXPECT_EQ
            (
                rotated->inside(vector(1, 1) + R*vector(x, y)), expected
            ) << x << ' ' << y;
        }
    }
    EXPECT_NEAR(rotated->area(), 2, 1e-12);
    EXPECT_LT((rotated->frame().axes - R).norm(), 1e-12);
    EXPECT_EQ(rotated->frame().origin, vector(1, 1));
}

TEST(Compound, unionAndDifferenceAreTheSetsOfTheirMembers)
{
    const std::string a = "type box; min (0 0 0); max (2 1 0);";
    const std::string b = "type circle; centre (2 1 0); radius 0.7;";
    const std::string members = "regions (a {" + a + "} b {" + b + "});";
    const auto first = region(a);
    const auto second = region(b);
    const auto both = region("type union;" + members);
    const auto rest = region("type difference;" + members);
    for (scalar x = -0.5; x < 3; x += 0.07)
    {
        for (scalar y = -0.5; y < 2; y += 0.07)
        {
            const vector point(x, y);
            const bool inA = first->inside(point), inB = second->inside(point);
            EXPECT_EQ(both->inside(point), inA || inB);
            EXPECT_EQ(rest->inside(point), inA && !inB);
        }
    }
    // The box corner is the centre of the circle: a quarter is shared
    const scalar quarter = pi*0.49/4;
    EXPECT_NEAR(both->area(), 2 + 3*quarter, 5e-4);
    EXPECT_NEAR(rest->area(), 2 - quarter, 5e-4);
    EXPECT_NEAR(both->bounds().max().x(), 2.7, 1e-12);
    EXPECT_NEAR(rest->bounds().max().x(), 2, 1e-12);
}

TEST(Compound, nests)
{
    const auto ring = region
    (
        "type union; regions"
        "("
        "    { type difference; regions"
        "      ("
        "          { type circle; centre (0 0 0); radius 2; }"
        "          { type circle; centre (0 0 0); radius 1; }"
        "      ); }"
        "    { type circle; centre (0 0 0); radius 0.5; }"
        ");"
    );
    EXPECT_TRUE(ring->inside({0, 0}));
    EXPECT_FALSE(ring->inside({0.75, 0}));
    EXPECT_TRUE(ring->inside({1.5, 0}));
    EXPECT_FALSE(ring->inside({2.1, 0}));
    EXPECT_NEAR(ring->area(), pi*(4 - 1 + 0.25), 1e-3);
}

TEST(DistanceToBorder, endsAtTheFirstGap)
{
    const auto lower = region("type box; min (0 0 0); max (1 1 0);");
    const auto middle = region("type box; min (0 1 0); max (1 2 0);");
    const auto upper = region("type box; min (0 2.1 0); max (1 3 0);");
    const std::vector<const Region*> all
    {
        upper.get(), lower.get(), middle.get()
    };
    const vector point(0.5, 0.25), up(0, 1);
    EXPECT_NEAR(distanceToBorder(all, point, up, 0), 1.75, 1e-12);
    EXPECT_NEAR(distanceToBorder(all, point, up, 0.2), 2.75, 1e-12);
    EXPECT_NEAR(distanceToBorder({lower.get()}, point, up, 0), 0.75, 1e-12);
    EXPECT_EQ(distanceToBorder({middle.get()}, point, up, 0.1), 0);
}
