#include "pairs/FusedSums.H"
#include "support/Lattice.H"
#include "support/Pairs.H"
#include "support/precision.H"
#include "support/Threads.H"

#include <gtest/gtest.h>

namespace sph
{

// A sum of every kind over the neighbours, weighted with the geometry, set
// into fields that are not read
template<bool packedRecords>
class everySum : public PairSum<everySum<packedRecords>>
{
public:
    static constexpr bool needsW = true;
    static constexpr bool packed = packedRecords;
    static constexpr auto reads =
        fields(of::V, of::U, of::s, of::gradU);

    template<class real>
    struct Sum
    {
        real VW;
        vectorOf<real> FU, VgradW;
        symmTensorOf<real> Vs;
        tensorOf<real> VG;
    };

    template<class I, class J, class Pair, class real>
    void add(const I& i, const J& j, const Pair& ij, Sum<real>& sum) const
    {
        using namespace of;
        sum.VW += j(V)*ij.W;
        sum.FU += ij.F*(j(U) - i(U));
        sum.VgradW += j(V)*ij.gradW();
        // r must not reach beyond what W and F see of it
        const real inside = select(ij.F < 0.0, real(1), real(0));
        sum.Vs += (inside*j(V))*j(s);
        sum.VG += (inside*(ij.r & ij.r))*j(gradU);
    }

    template<class At, class real>
    void finish(const At& i, const Sum<real>& sum) const
    {
        i.set(of::p, sum.VW);
        i.set(of::a, sum.FU);
        i.set(of::Us, sum.VgradW);
        i.set(of::T, sum.Vs);
        i.set(of::q, sum.VG.xx + 2.0*sum.VG.xy);
        i.set(of::I, sum.VG.yx + 2.0*sum.VG.yy);
    }
};

// lambda = 3; w = 2 lambda
class three : public PairSum<three>
{
public:
    static constexpr auto reads = fields(of::V);
    template<class real> using Sum = real;
    template<class I, class J, class P, class real>
    void add(const I&, const J&, const P&, real&) const {}
    template<class At, class real>
    void finish(const At& i, const real&) const
    {
        i.set(of::lambda, real(3));
    }
};

class twice : public PairSum<twice>
{
public:
    static constexpr auto reads = fields(of::V);
    template<class real> using Sum = real;
    template<class I, class J, class P, class real>
    void add(const I&, const J&, const P&, real&) const {}
    template<class At, class real>
    void finish(const At& i, const real&) const
    {
        i.set(of::w, 2.0*i(of::lambda));
    }
};

namespace
{

const FusedSums::Add<three, twice> fused;

struct pairWalk : testing::TestWithParam<std::string>
{
    Particles P{0.1};
    std::unique_ptr<Kernel> kernel = make<Kernel>(GetParam() + ";", 0.13);

    pairWalk()
    {
        place(P, randomPoints(611, {1, 1}, {3, 3}), 1);
        std::mt19937_64 engine(7);
        std::uniform_real_distribution<scalar> number(-1, 1);
        for (const char* name : {"V", "U", "s", "gradU"})
        {
            for (scalarField* c : P.field(name).components)
            {
                for (label i = 0; i < P.granular().end; ++i)
                {
                    (*c)[i] = number(engine);
                }
            }
        }
    }

    void walk(PairTerm& term)
    {
        const Pairs pairs(P, kernel->cutOff());
        PairWalk walk(P);
        walk.add(term);
        walk.run(pairs.list, *kernel);
    }

    template<class Term>
    void expectBruteForce()
    {
        Term term;
        walk(term);
        // Up to 80 terms; direct sums are made in double precision anyway
        const auto little = [](const scalar inDouble, const scalar inSingle)
        {
            return Term::packed ? rounding(inDouble, inSingle) : inDouble;
        };
        for (label i = 0; i < P.granular().end; ++i)
        {
            const auto sum = sumOneByOne(P, *kernel, term, i);
            const scalar W0 = kernel->W(0), F0 = -kernel->F(0);
            EXPECT_NEAR(P.p[i], sum.VW, little(1e-10, 5e-6)*W0);
            EXPECT_NEAR(P.a.x[i], sum.FU.x, little(1e-10, 3e-5)*F0);
            EXPECT_NEAR(P.a.y[i], sum.FU.y, little(1e-10, 3e-5)*F0);
            EXPECT_NEAR(P.Us.x[i], sum.VgradW.x, little(1e-11, 3e-7)*F0);
            EXPECT_NEAR(P.Us.y[i], sum.VgradW.y, little(1e-11, 3e-7)*F0);
            EXPECT_NEAR(P.T.xx[i], sum.Vs.xx, little(1e-12, 1e-5));
            EXPECT_NEAR(P.T.xy[i], sum.Vs.xy, little(1e-12, 1e-5));
            EXPECT_NEAR(P.T.yy[i], sum.Vs.yy, little(1e-12, 1e-5));
            const scalar qLittle = little(1e-12, 3e-6);
            EXPECT_NEAR(P.q[i], sum.VG.xx + 2*sum.VG.xy, qLittle);
            EXPECT_NEAR(P.I[i], sum.VG.yx + 2*sum.VG.yy, qLittle);
        }
    }
};

} // namespace

TEST_P(pairWalk, packedSumsAreThoseOfBruteForce)
{
    expectBruteForce<everySum<true>>();
}

TEST_P(pairWalk, directSumsAreThoseOfBruteForce)
{
    expectBruteForce<everySum<false>>();
}

TEST_P(pairWalk, bitsDoNotDependOnTheNumberOfThreads)
{
    everySum<true> term;
    {
        const Threads one(1);
        walk(term);
    }
    const scalarField VW = P.p, FU = P.a.x;
    for (const int n : {2, 3})
    {
        const Threads threads(n);
        walk(term);
        for (label i = 0; i < P.granular().end; ++i)
        {
            EXPECT_EQ(P.p[i], VW[i]);
            EXPECT_EQ(P.a.x[i], FU[i]);
        }
    }
}

TEST_P(pairWalk, termsAreFinishedInTheOrderOfTheirAddition)
{
    three a;
    twice b;
    everySum<true> other;
    const Pairs pairs(P, kernel->cutOff());
    for (const bool apart : {false, true})
    {
        std::fill(P.w.begin(), P.w.end(), 0);
        PairWalk walk(P);
        walk.add(a);
        if (apart)
        {
            walk.add(other);
        }
        walk.add(b);
        EXPECT_EQ(walk.passes(), apart ? 3 : 1);
        walk.run(pairs.list, *kernel);
        for (label i = 0; i < P.granular().end; ++i)
        {
            EXPECT_EQ(P.w[i], 6);
        }
    }
}

TEST_P(pairWalk, asksForAFieldOnce)
{
    PairWalk walk(P);
    three a;
    twice b;
    everySum<true> c;
    walk.add(a);
    walk.add(b);
    EXPECT_EQ(walk.fields().size(), 1u);
    walk.add(c);
    EXPECT_EQ(walk.fields().size(), 4u);
}

TEST_P(pairWalk, ofATermWithoutASumDoesNothing)
{
    PairTerm nothing;
    PairWalk walk(P);
    walk.add(nothing);
    EXPECT_FALSE(nothing.hasSum());
    EXPECT_EQ(walk.passes(), 0);
    EXPECT_TRUE(walk.fields().empty());
}

TEST_P(pairWalk, ofNothingDoesNothing)
{
    place(P, {}, 1);
    everySum<true> packed;
    everySum<false> direct;
    walk(packed);
    walk(direct);
}

namespace
{

// Some of the particles of pairWalk are awake, some watch; and images
struct partlyAsleep : pairWalk
{
    std::mt19937_64 engine{5};
    PairList list;

    partlyAsleep()
    {
        P.resizeGhosts(60);
        P.setAwake(200, 320);
        const Points points = randomPoints(60, {0.9, 1}, {1, 3}, 4);
        for (label k = 0; k < 60; ++k)
        {
            P.r.set(P.ghosts().begin + k, points[k]);
        }
        vary(P.ghosts());
        build(list);
    }

    void build(PairList& built) const
    {
        CellGrid grid;
        grid.build(P.r, {P.granular(), P.ghosts()}, kernel->cutOff());
        const ParticleRange all[2] = {{0, P.null()}, {0, 0}};
        built.build
        (
            P.r, P.active(), grid, all, kernel->cutOff(), P.null()
        );
    }

    // Other values of all that everySum reads
    void vary(const ParticleRange& range)
    {
        std::uniform_real_distribution<scalar> number(-1, 1);
        for (const char* name : {"V", "U", "s", "gradU"})
        {
            for (scalarField* c : P.field(name).components)
            {
                for (label i = range.begin; i < range.end; ++i)
                {
                    (*c)[i] = number(engine);
                }
            }
        }
    }

    void move(const ParticleRange& range)
    {
        std::uniform_real_distribution<scalar> shift(-1e-3, 1e-3);
        for (label i = range.begin; i < range.end; ++i)
        {
            P.r.set(i, P.r[i] + vector(shift(engine), shift(engine)));
        }
    }

    // What a walk sums up for those that are active, bit for bit
    std::vector<scalar> sums(PairWalk& walk)
    {
        walk.run(list, *kernel);
        std::vector<scalar> values;
        for (label i = 0; i < P.active().end; ++i)
        {
            for (const scalarField* f : {&P.p, &P.a.x, &P.a.y, &P.T.xy, &P.q})
            {
                values.push_back((*f)[i]);
            }
        }
        return values;
    }

    std::vector<scalar> afresh(PairTerm& term)
    {
        PairWalk walk(P);
        walk.add(term);
        return sums(walk);
    }
};

} // namespace

TEST_P(partlyAsleep, onlyThoseThatAreActiveAreSummed)
{
    everySum<true> term;
    const scalar untouched = 77;
    std::fill(P.p.begin(), P.p.end(), untouched);
    afresh(term);
    for (label i = 0; i < P.granular().end; ++i)
    {
        EXPECT_EQ(P.p[i] == untouched, i >= P.active().end) << i;
    }
}

// Those that are awake, that watch, and images, at every run
TEST_P(partlyAsleep, whatMayChangeIsPackedAgain)
{
    everySum<true> term;
    PairWalk walk(P);
    walk.add(term);
    auto before = sums(walk);
    for (const ParticleRange& range : {P.awake(), P.watching(), P.ghosts()})
    {
        vary(range);
        move(range);
        const auto now = sums(walk);
        EXPECT_NE(now, before);
        EXPECT_EQ(now, afresh(term));
        before = now;
    }
}

TEST_P(partlyAsleep, whatIsSoundAsleepIsPackedOnceAList)
{
    const ParticleRange sound{P.active().end, P.granular().end};
    everySum<true> term;
    PairWalk walk(P);
    walk.add(term);
    const auto before = sums(walk);
    vary(sound);
    EXPECT_EQ(sums(walk), before);
    EXPECT_NE(afresh(term), before);

    build(list);
    EXPECT_EQ(sums(walk), afresh(term));

    // Another list in between
    PairList other;
    build(other);
    vary(sound);
    walk.run(other, *kernel);
    EXPECT_EQ(sums(walk), afresh(term));
}

TEST_P(partlyAsleep, directSumsSeeEveryChange)
{
    everySum<false> term;
    PairWalk walk(P);
    walk.add(term);
    const auto before = sums(walk);
    vary({P.active().end, P.granular().end});
    const auto now = sums(walk);
    EXPECT_NE(now, before);
    EXPECT_EQ(now, afresh(term));
}

TEST_P(partlyAsleep, bitsDoNotDependOnTheNumberOfThreads)
{
    everySum<true> term;
    std::vector<scalar> one;
    for (const int n : {1, 2, 3})
    {
        const Threads threads(n);
        PairWalk walk(P);
        walk.add(term);
        sums(walk);
        engine.seed(9);
        vary(P.awake());
        const auto values = sums(walk);
        EXPECT_EQ(values, one.empty() ? values : one);
        one = values;
    }
}

INSTANTIATE_TEST_SUITE_P
(
    kernels, partlyAsleep, testing::Values("cubicSpline", "quinticSpline"),
    [](const auto& info) { return info.param; }
);

// The cubic spline is compiled into the loop, others are evaluated row by row
INSTANTIATE_TEST_SUITE_P
(
    kernels, pairWalk, testing::Values("cubicSpline", "quinticSpline"),
    [](const auto& info) { return info.param; }
);

} // namespace sph
