// Polylines of any shape: their dummies and the net at corners.
#include "boundaries/Boundaries.H"
#include "support/Lattice.H"

#include <gtest/gtest.h>

#include <sstream>

namespace sph
{

namespace
{

constexpr scalar dx = 0.1;

// Corners in the order of the polyline
std::string wall(const Points& points)
{
    std::ostringstream os;
    os.precision(17);
    os << "wall { type noSlip; points (";
    for (const vector& p : points)
    {
        os << '(' << p.x() << ' ' << p.y() << " 0)";
    }
    os << "); }";
    return os.str();
}

Boundaries boundaries(const Points& points)
{
    return Boundaries(dictionary::fromString(wall(points), "boundary"), dx);
}

// A regular polygon; inside: the material is in it
Points polygon(const label sides, const scalar R, const bool inside)
{
    Points points;
    for (label k = 0; k <= sides; ++k)
    {
        const scalar angle = (inside ? 2 : -2)*M_PI*(k % sides)/sides;
        points.push_back(R*vector(std::cos(angle), std::sin(angle)));
    }
    return points;
}

// A V whose sides meet at an angle [deg]; the material is in it
Points valley(const scalar degrees)
{
    const scalar half = 0.5*degrees*M_PI/180;
    const vector up(std::sin(half), std::cos(half));
    return {vector(-2*up.x(), 2*up.y()), {0, 0}, 2*up};
}

scalar nearest
(
    const std::vector<WallParticle>& walls, const vector& r,
    const WallParticle* except = nullptr
)
{
    scalar best = 1e30;
    for (const WallParticle& w : walls)
    {
        best = &w == except ? best : std::min(best, (w.r - r).norm());
    }
    return best;
}

struct Shape
{
    const char* name;
    Points points;
    scalar largestGap;      // between a place behind the wall and a dummy
    scalar closest = 0.6;   // distance between two dummies
};

// Neither gaps, nor overlaps, nor dummies in the material
void expectSoundLayers(const Shape& shape)
{
    const Boundaries all = boundaries(shape.points);
    const auto walls = all.wallParticles();
    scalar closest = 1e30, widest = 0, foremost = 1e30;
    for (const WallParticle& w : walls)
    {
        closest = std::min(closest, nearest(walls, w.r, &w));
        EXPECT_LT(all.distance(w.r).first, 0) << w.r.transpose();
    }
    for (scalar x = -2.5; x < 2.5; x += 0.043)
    {
        for (scalar y = -2.5; y < 2.5; y += 0.037)
        {
            const scalar d = all.distance({x, y}).first;
            if (d > 0 && d < 1)
            {
                foremost = std::min(foremost, nearest(walls, {x, y}));
            }
            if (d < -0.3*dx && d > -2.7*dx)
            {
                widest = std::max(widest, nearest(walls, {x, y}));
            }
        }
    }
    EXPECT_GT(closest, shape.closest*dx) << shape.name;
    EXPECT_LT(widest, shape.largestGap*dx) << shape.name;
    EXPECT_GT(foremost, 0.45*dx) << shape.name;
}

} // namespace

TEST(corners, ofAnyAngleHaveSoundLayers)
{
    for (const scalar degrees : {20, 30, 45, 60, 90, 120, 150, 175})
    {
        const Points v = valley(degrees);
        // The last ones of two rows, half a spacing from their corner
        const scalar closest = std::max
        (
            std::min(0.95*std::sin(degrees*M_PI/360), 0.6), 0.2399
        );
        expectSoundLayers({"valley", v, 1, closest});
        // Within the tip of a sharp edge there is no room for a particle
        const scalar gap = degrees < 45 ? 1.4 : 1;
        expectSoundLayers({"edge", {v[2], v[1], v[0]}, gap, closest});
    }
}

TEST(corners, ofRoundWallsHaveSoundLayers)
{
    for (const label sides : {8, 12, 24, 200})
    {
        expectSoundLayers({"drum", polygon(sides, 1, true), 1});
        expectSoundLayers({"pole", polygon(sides, 1, false), 1});
    }
    // Not room enough for three layers
    expectSoundLayers({"thin pole", polygon(40, 0.17, false), 1});
}

// Segments much shorter than dx make as many particles as one long one
TEST(corners, shortSegmentsMakeNoMoreParticles)
{
    Points fine;
    for (label k = 0; k <= 100; ++k)
    {
        fine.push_back({0.02*k, 0});
    }
    const auto walls = boundaries(fine).wallParticles();
    const auto same = boundaries({{0, 0}, {2, 0}}).wallParticles();
    ASSERT_EQ(walls.size(), same.size());
    for (std::size_t k = 0; k < walls.size(); ++k)
    {
        EXPECT_LT((walls[k].r - same[k].r).norm(), 1e-12);
    }
}

// Both faces of a plate have material: its dummies stay in it
TEST(corners, ofAThinPlateKeepItsParticlesInside)
{
    for (const scalar thickness : {1.0, 2.0, 3.0, 4.0, 6.0})
    {
        const scalar y = thickness*dx;
        const Points plate{{0, 0}, {0, y}, {2, y}, {2, 0}, {0, 0}};
        expectSoundLayers({"plate", plate, 1});
        // A row along the middle ends half a spacing early
        const label count = label(boundaries(plate).wallParticles().size());
        EXPECT_LE(count, 20*thickness);
        EXPECT_GE(count, 20*thickness - 1);
    }
}

TEST(corners, aWallThatTurnsBackIsRefused)
{
    EXPECT_THROW(boundaries({{0, 0}, {1, 0}, {0.5, 0}}), IOError);
}

// What has got past a corner comes back, from wherever it is
TEST(corners, theNetHasNoHoleThere)
{
    for (const scalar degrees : {20, 30, 45, 60, 90, 120, 150, 175})
    {
        const Points v = valley(degrees);
        for (const bool edge : {false, true})
        {
            const Boundaries walls =
                boundaries(edge ? Points{v[2], v[1], v[0]} : v);
            for (scalar x = -0.3; x < 0.3; x += 0.023)
            {
                for (scalar y = -0.3; y < 0.5; y += 0.029)
                {
                    const scalar before = walls.distance({x, y}).first;
                    if (before < -1.9*dx)
                    {
                        continue;
                    }
                    Particles P(dx);
                    place(P, {{x, y}}, 1000);
                    P.U.set(0, {-0.3*x, -1 - y});
                    const label caught = walls.net(P);
                    const scalar after = walls.distance(P.r[0]).first;
                    EXPECT_EQ(caught, before < 0.25*dx);
                    EXPECT_GT(after, 0.2499*dx)
                        << degrees << ' ' << x << ' ' << y;
                    EXPECT_LT((P.r[0] - vector(x, y)).norm(), 5.5*dx);
                    EXPECT_EQ(walls.net(P), 0) << "once is enough";
                    // Not into the wall
                    const vector next = P.r[0] + 1e-4*dx*P.U[0];
                    if (caught)
                    {
                        EXPECT_GT
                        (
                            walls.distance(next).first, after - 1e-7*dx
                        ) << degrees << ' ' << x << ' ' << y;
                    }
                }
            }
        }
    }
}

} // namespace sph
