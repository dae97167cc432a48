// Water at rest in tanks of any shape: turned by 45 degrees, with sloping
// sides, and in a hopper with an acute corner.
#include "support/Scene.H"

#include <gtest/gtest.h>

#include <cstdio>
#include <numeric>
#include <sstream>

namespace sph
{

namespace
{

constexpr scalar dx = 0.005, g = 9.81;

std::string wall(const word& type, const Points& points)
{
    std::ostringstream os;
    os.precision(17);
    os << "tank { type " << type << "; points (";
    for (const vector& p : points)
    {
        os << '(' << p.x() << ' ' << p.y() << " 0)";
    }
    os << "); }";
    return os.str();
}

CaseText water()
{
    CaseText text;
    text.rheology = "rheology Newtonian; NewtonianCoeffs { eta 10; }";
    text.equationOfState =
        "equationOfState linear; linearCoeffs { KFactor 100; H 0.1; }";
    return text;
}

// Density at rest at a depth [m]
void setDepthsOfWater(TestScene& scene, const vector& up, const scalar H)
{
    Particles& P = scene.particles;
    const scalar K = scene.material.eos().K(), rho0 = CaseText::rho0;
    for (label i = 0; i < P.granular().end; ++i)
    {
        const scalar z = std::max(H - P.r[i].dot(up), 0.0);
        P.rho[i] = rho0*std::exp(rho0*g*z/K);
    }
}

// Mean height of the surface over columns 2 dx wide near the middle
scalar levelOf(const Particles& P)
{
    scalar tops[4] = {};
    for (label i = 0; i < P.granular().end; ++i)
    {
        const label column = label(std::floor(P.r.x[i]/(2*dx))) + 2;
        if (column >= 0 && column < 4)
        {
            tops[column] = std::max(tops[column], P.r.y[i] + 0.5*dx);
        }
    }
    return std::accumulate(tops, tops + 4, 0.0)/4;
}

// A triangular lattice of the density of the square one: its rows stand
// parallel to the sides of tanks whose corners have 60 or 120 degrees
const scalar a = dx*std::sqrt(2/std::sqrt(3)), b = a*std::sqrt(3)/2;

// Rows from the bottom up, each longer than the one below by some particles
Points rowsOf(const label first, const label longer, const scalar y0)
{
    Points points;
    for (label j = 0; y0 + b*j < 0.1; ++j)
    {
        const label n = first + longer*j;
        for (label k = 0; k < n; ++k)
        {
            points.push_back({(k - 0.5*(n - 1))*a, y0 + b*j});
        }
    }
    return points;
}

struct Tank
{
    const char* name;
    scalar degrees;     // at its lower corners
    scalar base;        // width of the bottom [m]
    scalar spread;      // of both sides together, a metre of height
    Points points;      // none: a square lattice, cut by the sides
};

const scalar slope = 2/std::sqrt(3);

const Tank box{"box", 90, 0.1, 0, squareLattice({-0.05, 0}, 20, 20, dx)};
const Tank widening{"widening", 120, 19.5*a, slope, rowsOf(20, 1, 0.5*b)};
const Tank narrowing{"narrowing", 60, 36.5*a, -slope, rowsOf(36, -1, 0.5*b)};
const Tank hopper60{"hopper60", 60, 0, slope, rowsOf(1, 1, b)};
const Tank hopper30{"hopper30", 30, 0, 2*std::tan(M_PI/12), {}};
const Tank cutBox{"cutBox", 75, 0.1, 2/std::tan(75*M_PI/180), {}};

std::ostream& operator<<(std::ostream& os, const Tank& tank)
{
    return os << tank.name;
}

class tanks : public testing::TestWithParam<Tank>
{};

} // namespace

TEST(turnedBox, isTheUnturnedOne)
{
    const auto result = [](const scalar degrees)
    {
        const scalar angle = degrees*M_PI/180;
        tensor R;
        R << std::cos(angle), -std::sin(angle),
             std::sin(angle), std::cos(angle);
        Points corners{{0, 0}, {0.1, 0}, {0.1, 0.1}, {0, 0.1}, {0, 0}};
        Points points = squareLattice({0, 0}, 20, 14, dx);
        for (Points* list : {&corners, &points})
        {
            for (vector& p : *list)
            {
                p = R*p;
            }
        }
        CaseText text = water();
        text.g = R*vector(0, -g);
        text.boundary = wall("noSlip", corners);
        TestScene scene(text, dx, points);
        setDepthsOfWater(scene, R*vector(0, 1), 14*dx);
        scene.scheme.initialise();
        scene.run(scene.acousticStep(), 300);
        EXPECT_EQ(scene.netHits, 0);
        std::map<std::int64_t, std::array<scalar, 3>> state;
        const Particles& P = scene.particles;
        for (label i = 0; i < P.granular().end; ++i)
        {
            const vector r = R.transpose()*P.r[i];
            state[P.id[i]] = {r.x(), r.y(), P.p[i]};
        }
        return state;
    };
    const auto straight = result(0), turned = result(45);
    scalar position = 0, pressure = 0;
    for (const auto& [id, a] : straight)
    {
        const auto& b = turned.at(id);
        position = std::max
        (
            {position, std::abs(a[0] - b[0]), std::abs(a[1] - b[1])}
        );
        pressure = std::max(pressure, std::abs(a[2] - b[2]));
    }
    std::printf
    (
        "differences: position %.1e dx, pressure %.1e Pa\n",
        position/dx, pressure
    );
    EXPECT_LT(position, 1e-7*dx);
    EXPECT_LT(pressure, 1e-6*CaseText::rho0*g*0.07);
}

TEST_P(tanks, keepTheirWaterAndItsPressure)
{
    const Tank& tank = GetParam();
    const scalar H = 0.1, top = 0.14;
    const auto half = [&](const scalar y)
    {
        return 0.5*(tank.base + tank.spread*y);
    };
    Points corners{{-half(top), top}, {-half(0), 0}, {half(0), 0},
        {half(top), top}};
    if (tank.base == 0)
    {
        corners.erase(corners.begin() + 1);
    }
    CaseText text = water();
    text.boundary = wall("freeSlip", corners);
    Points points = tank.points;
    if (points.empty())
    {
        const Boundaries walls
        (
            dictionary::fromString(text.boundary, "boundary"), dx
        );
        for (const vector& r : squareLattice({-0.3, 0}, 120, 20, dx))
        {
            const bool inside = std::abs(r.x()) < half(r.y());
            if (inside && walls.distance(r).first > 0.25*dx)
            {
                points.push_back(r);
            }
        }
    }
    TestScene scene(text, dx, points);
    setDepthsOfWater(scene, {0, 1}, H);
    scene.scheme.initialise();
    const scalar dt = scene.acousticStep();
    scene.run(dt, label(0.3/dt));

    const Particles& P = scene.particles;
    const scalar level = levelOf(P);
    const scalar base = CaseText::rho0*g*level;
    scalar error = 0, nearCorner = 0, mean = 0, fastest = 0;
    label outside = 0, corner = 0;
    for (label i = 0; i < P.granular().end; ++i)
    {
        const scalar exact = CaseText::rho0*g*(level - P.r.y[i]);
        const scalar square = std::pow((P.p[i] - exact)/base, 2);
        error += square;
        mean += (P.p[i] - exact)/base/P.granular().size();
        if
        (
            std::min
            (
                (P.r[i] - vector(half(0), 0)).norm(),
                (P.r[i] + vector(half(0), 0)).norm()
            ) < 4*dx
        )
        {
            nearCorner += square;
            ++corner;
        }
        fastest = std::max(fastest, P.U[i].norm());
        outside += scene.boundaries.distance(P.r[i]).first < 0;
    }
    error = std::sqrt(error/P.granular().size());
    nearCorner = std::sqrt(nearCorner/std::max(corner, 1));
    std::printf
    (
        "%s, corner of %.0f deg, %d particles: RMS error of p %.2f %% of that"
        " at the base, mean %.2f %%;\nwithin 4 dx of a corner %.2f %% (%d"
        " particles); level %.4f m;"
        " fastest/sqrt(g H) %.4f; net hits %d\n",
        tank.name, tank.degrees, P.granular().size(), 100*error,
        100*mean, 100*nearCorner, corner, level, fastest/std::sqrt(g*H),
        scene.netHits
    );
    if (!tank.points.empty())
    {
        EXPECT_LT(error, 0.03);
        EXPECT_LT(nearCorner, 0.06);
    }
    EXPECT_EQ(outside, 0);
    EXPECT_EQ(scene.netHits, 0);
    EXPECT_LT(fastest, 0.03*std::sqrt(g*H));
}

INSTANTIATE_TEST_SUITE_P
(
    shapes, tanks,
    testing::Values(box, widening, narrowing, hopper60, hopper30, cutBox),
    [](const auto& info) { return std::string(info.param.name); }
);

} // namespace sph
