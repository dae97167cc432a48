// What the pair loop computes with, in either precision: lanes, and what is
// packed into them.
#include "pairs/Packing.H"
#include "support/Lattice.H"
#include "support/precision.H"

#include <gtest/gtest.h>

#include <array>

namespace sph
{

namespace
{

constexpr label W = width<pairLanes>;

using Lanes = std::array<scalar, W>;

Lanes valuesOf(const pairLanes& a)
{
    pairScalar values[W];
    static_assert(sizeof values == sizeof a);
    std::memcpy(values, &a, sizeof values);
    Lanes result;
    std::copy(values, values + W, result.begin());
    return result;
}

// Pairs of points within 3h of each other, with x and y around an origin
struct packing : testing::TestWithParam<scalar>
{
    vectorField ri, rj;

    // unit: coordinates are multiples of it, if it is not 0
    void lay(const scalar h, const scalar reach, const scalar unit = 0)
    {
        const label n = 100*W;
        const vector origin = GetParam()*h*vector(1, -1);
        const vector box = vector::Constant(reach/2);
        const Points a = randomPoints(n, -box, box, 3);
        const Points b = randomPoints(n, -box, box, 4);
        const auto place = [&](const vector& r) -> vector
        {
            return origin
              + (unit > 0 ? vector(unit*(r/unit).array().round()) : r);
        };
        ri.x.resize(n), ri.y.resize(n);
        rj.x.resize(n), rj.y.resize(n);
        for (label i = 0; i < n; ++i)
        {
            ri.set(i, place(a[i]));
            rj.set(i, place(b[i]));
        }
    }

    // Of particles i ... i + W - 1 of a and b, as the pair loop sees it
    static vectorOf<pairLanes> distance
    (
        const scalar h, const vectorField& a, const vectorField& b,
        const label i
    )
    {
        const Packing<pairLanes> packing(h);
        const scalar* from[2] = {a.x.data(), a.y.data()};
        const scalar* to[2] = {b.x.data(), b.y.data()};
        pairLanes ra[2], rb[2];
        for (label c = 0; c < 2; ++c)
        {
            ra[c] = toLanes(packing.row(from, c, i));
            rb[c] = toLanes(packing.row(to, c, i));
        }
        return packing.distance(ra, rb);
    }

    // check(r_ij, r_ji, r_i - r_j in double precision) of all components
    template<class Check>
    void forAll(const scalar h, const Check& check) const
    {
        for (label i = 0; i < label(ri.x.size()); i += W)
        {
            const vectorOf<pairLanes> ij = distance(h, ri, rj, i);
            const vectorOf<pairLanes> ji = distance(h, rj, ri, i);
            const Lanes x = valuesOf(ij.x), y = valuesOf(ij.y);
            const Lanes minusX = valuesOf(ji.x), minusY = valuesOf(ji.y);
            for (label k = 0; k < W; ++k)
            {
                const vector r = ri[i + k] - rj[i + k];
                check(x[k], minusX[k], r.x());
                check(y[k], minusY[k], r.y());
            }
        }
    }
};

} // namespace

// 2^-24 h by packing, and three roundings of the distance itself
TEST_P(packing, keepsTheDigitsOfDistances)
{
    const scalar h = 0.013;
    lay(h, 3*h);
    forAll
    (
        h, [&](const scalar r, const scalar minusR, const scalar exact)
        {
            const scalar bound = std::ldexp(h + 3*std::abs(exact), -24);
            EXPECT_LE(std::abs(r - exact), rounding(0, bound));
            EXPECT_EQ(r, -minusR);
        }
    );
}

// In units of 2^-24 h nothing is rounded
TEST_P(packing, isExactInItsUnits)
{
    const scalar h = 0.125;
    lay(h, h, std::ldexp(h, -24));
    forAll
    (
        h, [](const scalar r, const scalar minusR, const scalar exact)
        {
            EXPECT_EQ(r, exact);
            EXPECT_EQ(r, -minusR);
        }
    );
}

// Over h: the integers, modulo 2^32, jump at 128 + 256 k
INSTANTIATE_TEST_SUITE_P
(
    origins, packing, testing::Values(0, 1, 128, -128, 256, 1e4, -1e4, 10112),
    [](const auto& info) { return "number" + std::to_string(info.index); }
);

TEST(pairLanes, holdOtherColumnsRounded)
{
    scalarField values(W);
    for (label k = 0; k < W; ++k)
    {
        values[k] = (k % 2 == 0 ? 1 : -1)*std::pow(10, 2*k - 7)/3;
    }
    const scalar* columns[3] = {nullptr, nullptr, values.data()};
    const Packing<pairLanes> packing(0.1);
    const Lanes row = valuesOf(toLanes(packing.row(columns, 2, 0)));
    const Lanes loaded = valuesOf(load<pairLanes>(values.data()));
    for (label k = 0; k < W; ++k)
    {
        const scalar bound = std::ldexp(std::abs(values[k]), -24);
        EXPECT_LE(std::abs(row[k] - values[k]), rounding(0, bound));
        EXPECT_EQ(loaded[k], row[k]);
    }
}

TEST(pairLanes, haveAnInverseSquareRoot)
{
    for (scalar a = 1e-20; a < 1e20; a *= 1.01)
    {
        // As it is rounded itself
        const scalar exact = 1/std::sqrt(scalar(pairScalar(a)));
        for (const scalar got : valuesOf(invSqrt(pairLanes(a))))
        {
            EXPECT_NEAR(got/exact, 1, rounding(1e-12, 3e-7)) << a;
        }
    }
}

// Every pattern of the lanes
TEST(pairLanes, areChosenOneByOne)
{
    for (label pattern = 0; pattern < 1 << W; ++pattern)
    {
        alignedList<pairScalar> a(W), b(W);
        for (label k = 0; k < W; ++k)
        {
            a[k] = k + 1;
            b[k] = pattern & 1 << k ? k + 2 : -k - 2;
        }
        pairLanes x, y;
        std::memcpy(&x, a.data(), sizeof x);
        std::memcpy(&y, b.data(), sizeof y);
        const Lanes less = valuesOf(select(x < y, x, y));
        for (label k = 0; k < W; ++k)
        {
            EXPECT_EQ(less[k], std::min(a[k], b[k])) << pattern;
        }
    }
}

// a[c][lane] = records[lane][c]
TEST(pairLanes, areLoadedFromRecords)
{
    alignedList<pairScalar> values(W*W);
    const pairScalar* records[W];
    for (label k = 0; k < W*W; ++k)
    {
        values[k] = k;
        records[k % W] = values.data() + k % W*W;
    }
    pairRow rows[W];
    loadTransposed(records, rows);
    for (label c = 0; c < W; ++c)
    {
        for (label lane = 0; lane < W; ++lane)
        {
            EXPECT_EQ(rows[c][lane], lane*W + c);
        }
    }
}

namespace
{

template<class real>
struct SomeSums
{
    real a;
    vectorOf<real> b;
    tensorOf<real> c;
};

} // namespace

// A sum in lanes is what some lanes of it in pairLanes are
TEST(pairLanes, areHandedOnInParts)
{
    constexpr label n = 7, part = width<lanes>;
    scalarField values(n*W);
    SomeSums<pairLanes> sum;
    pairLanes all[n];
    for (label c = 0; c < n; ++c)
    {
        for (label k = 0; k < W; ++k)
        {
            values[c*W + k] = 100*c + k;
        }
        all[c] = load<pairLanes>(values.data() + c*W);
    }
    static_assert(sizeof sum == sizeof all);
    std::memcpy(&sum, all, sizeof sum);

    for (label at = 0; at < W; at += part)
    {
        const auto some = partOf<SomeSums<lanes>>(sum, at);
        const lanes* const components[n] =
            {&some.a, &some.b.x, &some.b.y,
             &some.c.xx, &some.c.xy, &some.c.yx, &some.c.yy};
        for (label c = 0; c < n; ++c)
        {
            for (label k = 0; k < part; ++k)
            {
                EXPECT_EQ((*components[c])[k], 100*c + at + k);
            }
        }
    }
}

} // namespace sph
