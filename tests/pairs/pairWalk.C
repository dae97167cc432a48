#include "pairs/FusedSums.H"
#include "support/Lattice.H"
#include "support/Pairs.H"
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
        for (label i = 0; i < P.granular().end; ++i)
        {
            const auto sum = sumOneByOne(P, *kernel, term, i);
            const scalar W0 = kernel->W(0), F0 = -kernel->F(0);
            EXPECT_NEAR(P.p[i], sum.VW, 1e-10*W0);
            EXPECT_NEAR(P.a.x[i], sum.FU.x, 1e-10*F0);
            EXPECT_NEAR(P.a.y[i], sum.FU.y, 1e-10*F0);
            EXPECT_NEAR(P.Us.x[i], sum.VgradW.x, 1e-11*F0);
            EXPECT_NEAR(P.Us.y[i], sum.VgradW.y, 1e-11*F0);
            EXPECT_NEAR(P.T.xx[i], sum.Vs.xx, 1e-12);
            EXPECT_NEAR(P.T.xy[i], sum.Vs.xy, 1e-12);
            EXPECT_NEAR(P.T.yy[i], sum.Vs.yy, 1e-12);
            EXPECT_NEAR(P.q[i], sum.VG.xx + 2*sum.VG.xy, 1e-12);
            EXPECT_NEAR(P.I[i], sum.VG.yx + 2*sum.VG.yy, 1e-12);
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

// The cubic spline is compiled into the loop, others are evaluated row by row
INSTANTIATE_TEST_SUITE_P
(
    kernels, pairWalk, testing::Values("cubicSpline", "quinticSpline"),
    [](const auto& info) { return info.param; }
);

} // namespace sph
