#include "deposit/DepositGauge.H"
#include "heaps.H"

#include <gtest/gtest.h>

using namespace sph;

static const vector g(0, -9.81);
static constexpr scalar dx = 0.005;

static DepositGauge gaugeOf
(
    const std::string& text, const std::vector<vector>& start,
    const vector& gravity = g
)
{
    const dictionary dict = dictionary::fromString(text);
    Particles particles(dx);
    heaps::place(particles, start);
    DepositGauge gauge(dict, particles, heaps::rho0, gravity);
    dict.refuseUnused();
    return gauge;
}

static Deposit measure
(
    const DepositGauge& gauge, const std::vector<vector>& points
)
{
    Particles particles(dx);
    heaps::place(particles, points);
    return gauge.measure(particles);
}

static std::vector<vector> mirrored(std::vector<vector> points)
{
    for (vector& point : points)
    {
        point.x() *= -1;
    }
    return points;
}


TEST(DepositGauge, takesLengthAndHeightOfTheColumnFromTheStart)
{
    const DepositGauge gauge = gaugeOf("", heaps::column(0.2, 0.15, dx));
    EXPECT_NEAR(gauge.L0(), 0.2, 1e-10);
    EXPECT_NEAR(gauge.H0(), 0.15, 1e-10);
    EXPECT_NEAR(gauge.tc(), std::sqrt(0.15/9.81), 1e-10);
    EXPECT_DOUBLE_EQ(gauge.threshold(), 0.5*dx);
}


TEST(DepositGauge, knowsWhereAColumnOnABedStands)
{
    const auto start = heaps::below
    (
        [](const scalar x) { return x < 0.1 ? 0.25 : 0.1; }, 0, 0.5, dx
    );
    EXPECT_NEAR(gaugeOf("L0 0.1; H0 0.15;", start).foot(), 0.1, 1e-10);
    EXPECT_EQ(gaugeOf("H0 0.248;", start).foot(), 0);
    EXPECT_EQ(gaugeOf("", start).foot(), 0);
}


TEST(DepositGauge, measuresRunoutAndHeightOfATriangle)
{
    const DepositGauge gauge = gaugeOf
    (
        "L0 0.2; H0 0.15; threshold 0.01;", heaps::column(0.2, 0.15, dx)
    );
    const Deposit deposit = measure(gauge, heaps::triangle(0.45, 0.13, dx));
    const scalar front = 0.45*(1 - 0.01/0.13);
    EXPECT_NEAR(deposit.reach, front, 1.2*dx);
    EXPECT_NEAR(deposit.runout, front/0.2 - 1, 1.2*dx/0.2);
    EXPECT_NEAR(deposit.height, 0.13, dx);
    EXPECT_NEAR(deposit.heightAtOrigin, 0.13, dx);
}


TEST(DepositGauge, givesTheSameOnEitherSide)
{
    const auto column = heaps::column(0.2, 0.15, dx);
    const auto heap = heaps::triangle(0.45, 0.13, dx);
    const Deposit right = measure(gaugeOf("side right;", column), heap);
    const Deposit left = measure
    (
        gaugeOf("side left;", mirrored(column)), mirrored(heap)
    );
    EXPECT_NEAR(left.runout, right.runout, 1e-10);
    EXPECT_NEAR(left.heightAtOrigin, right.heightAtOrigin, 1e-10);

    auto twoColumns = column, twoHeaps = heap;
    for (const vector& point : mirrored(column)) twoColumns.push_back(point);
    for (const vector& point : mirrored(heap)) twoHeaps.push_back(point);
    const Deposit both = measure(gaugeOf("side both;", twoColumns), twoHeaps);
    EXPECT_NEAR(both.runout, right.runout, 1e-10);
    EXPECT_NEAR(both.reach, right.reach, 1e-10);
    EXPECT_NEAR(both.front.left, -both.front.right, 1e-10);
}


TEST(DepositGauge, doesNotKnowWhereTheBinsLie)
{
    const auto heap = heaps::triangle(0.45, 0.13, dx);
    const DepositGauge gauge = gaugeOf("", heaps::column(0.2, 0.15, dx));
    const Deposit here = measure(gauge, heap);
    for (label i = 1; i < 20; ++i)
    {
        auto moved = heap;
        for (vector& point : moved)
        {
            point.x() += 0.1*i*dx;
        }
        const Deposit there = measure(gauge, moved);
        EXPECT_NEAR(there.reach, here.reach + 0.1*i*dx, 0.08*dx);
        EXPECT_NEAR(there.height, here.height, 0.12*dx);
    }
}


TEST(DepositGauge, measuresAlongAnIncline)
{
    const scalar angle = 30*pi/180;
    const vector along(std::cos(angle), -std::sin(angle));
    const vector up(std::sin(angle), std::cos(angle));
    const auto turned = [&](std::vector<vector> points)
    {
        for (vector& point : points)
        {
            point = vector(0.1, 0.6) + point.x()*along + point.y()*up;
        }
        return points;
    };
    const auto column = heaps::column(0.2, 0.15, dx);
    const auto heap = heaps::triangle(0.45, 0.13, dx);

    const Deposit level = measure(gaugeOf("", column), heap);
    const Deposit inclined = measure
    (
        // the direction need not be a unit vector
        gaugeOf
        (
            "origin (0.1 0.6 0); direction (1.7320508075688772 -1 0);",
            turned(column)
        ),
        turned(heap)
    );
    EXPECT_NEAR(inclined.runout, level.runout, 1e-8);
    EXPECT_NEAR(inclined.height, level.height, 1e-8);
}


TEST(DepositGauge, countsTheMassThatMoved)
{
    const auto start = heaps::column(0.2, 0.1, dx);
    const DepositGauge gauge = gaugeOf("mobilisedByDx 2;", start);
    Particles particles(dx);
    heaps::place(particles, start);
    const label n = particles.granular().size();
    for (label i = 0; i < n/4; ++i)
    {
        particles.r.x[i] += 2.1*dx;
    }
    for (label i = n/4; i < n/2; ++i)
    {
        particles.r.y[i] += 1.9*dx;
    }
    EXPECT_NEAR(gauge.mobilised(particles), 0.25, 1e-12);

    // identity goes by id, whatever the order of the particles
    labelField reverse(n);
    for (label i = 0; i < n; ++i)
    {
        reverse[i] = n - 1 - i;
    }
    particles.reorderGranular(reverse);
    EXPECT_NEAR(gauge.mobilised(particles), 0.25, 1e-12);
}


TEST(DepositGauge, refusesWrongEntries)
{
    const auto column = heaps::column(0.2, 0.15, dx);
    for
    (
        const std::string text :
        {
            "side up;", "threshold -1;", "threshold 0.01; thresholdByDx 1;",
            "direction (0 0 0);", "L0 0;", "binWidth 0;", "H0 -0.1;",
            "thresholdBydx 2;"
        }
    )
    {
        EXPECT_THROW(gaugeOf(text, column), IOError) << text;
    }
    // all of the column lies on the other side
    EXPECT_THROW(gaugeOf("origin (0.3 0 0);", column), IOError);
}
