#include "support/Lattice.H"
#include "support/Pairs.H"
#include "support/Threads.H"

#include <gtest/gtest.h>

namespace sph
{

namespace
{

// A sum of every kind over the neighbours, weighted with the geometry
class sums : public PairTerm
{
    PairWalk::Slot V_, U_, s_, gradU_;

public:
    scalarField VW, rSqr;
    vectorField VgradW, FU;
    symmTensorField Vs;
    tensorField VG;

    explicit sums(PairWalk& walk)
    :
        V_(walk.neighbour("V")),
        U_(walk.neighbour("U")),
        s_(walk.neighbour("s")),
        gradU_(walk.neighbour("gradU"))
    {
        walk.needsW();
        const std::size_t n = walk.particles().r.x.size();
        for
        (
            scalarField* f :
            {
                &VW, &rSqr, &VgradW.x, &VgradW.y, &FU.x, &FU.y, &Vs.xx, &Vs.xy,
                &Vs.yy, &VG.xx, &VG.xy, &VG.yx, &VG.yy
            }
        )
        {
            f->assign(n, NAN);
        }
    }

    void evaluate(const PairBlock& block) override
    {
        lanes sumVW = 0, sumRSqr = 0;
        vectorLanes sumVgradW{0, 0}, sumFU{0, 0};
        symmTensorLanes sumVs{0, 0, 0};
        tensorLanes sumVG{0, 0, 0, 0};
        for (label k = 0; k < block.n; ++k)
        {
            const lanes V = block.scalar(V_, k);
            sumVW += V*block.W(k);
            sumRSqr += V*(block.rSqr(k) - (block.r(k) & block.r(k)));
            sumVgradW += V*block.gradW(k);
            sumFU += block.F(k)*block.vector(U_, k);
            const symmTensorLanes s = block.symmTensor(s_, k);
            sumVs = sumVs + symmTensorLanes{V*s.xx, V*s.xy, V*s.yy};
            const tensorLanes G = block.tensor(gradU_, k);
            sumVG += tensorLanes{V*G.xx, V*G.xy, V*G.yx, V*G.yy};
        }
        store(sumVW, &VW[block.first]);
        store(sumRSqr, &rSqr[block.first]);
        store(sumVgradW, VgradW, block.first);
        store(sumFU, FU, block.first);
        store(sumVs, Vs, block.first);
        store(sumVG, VG, block.first);
    }
};

struct pairWalk : testing::Test
{
    Particles P{0.1};
    std::unique_ptr<Kernel> kernel = make<Kernel>("cubicSpline;", 0.13);

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

    sums walked(const PairWalk::Fetch fetch)
    {
        const Pairs pairs(P, kernel->cutOff());
        PairWalk walk(P, fetch);
        sums term(walk);
        walk.add(term);
        walk.run(pairs.list, *kernel);
        return term;
    }
};

} // namespace

TEST_F(pairWalk, sumsAreThoseOfBruteForce)
{
    for (const auto fetch : {PairWalk::Fetch::packed, PairWalk::Fetch::direct})
    {
        const sums got = walked(fetch);
        for (label i = 0; i < P.granular().end; ++i)
        {
            scalar VW = 0;
            vector VgradW = vector::Zero(), FU = vector::Zero();
            tensor Vs = tensor::Zero(), VG = tensor::Zero();
            for (label j = 0; j < P.granular().end; ++j)
            {
                const vector r = P.r[i] - P.r[j];
                if (j == i || r.norm() >= kernel->cutOff())
                {
                    continue;
                }
                VW += P.V[j]*kernel->W(r.norm());
                VgradW += P.V[j]*kernel->F(r.norm())*r;
                FU += kernel->F(r.norm())*P.U[j];
                Vs += P.V[j]*P.s[j];
                VG += P.V[j]*P.gradU[j];
            }
            EXPECT_NEAR(got.VW[i], VW, 1e-11*kernel->W(0));
            EXPECT_NEAR(got.rSqr[i], 0, 1e-16);
            EXPECT_LT
            (
                (got.VgradW[i] - VgradW).norm(), -1e-11*0.1*kernel->F(0)
            );
            EXPECT_LT((got.FU[i] - FU).norm(), -1e-11*kernel->F(0));
            EXPECT_LT((got.Vs[i] - Vs).norm(), 1e-12);
            EXPECT_LT((got.VG[i] - VG).norm(), 1e-12);
        }
    }
}

TEST_F(pairWalk, bitsDoNotDependOnTheNumberOfThreads)
{
    const auto with = [&](const int n)
    {
        const Threads threads(n);
        return walked(PairWalk::Fetch::packed);
    };
    const sums one = with(1);
    for (const int n : {2, 3})
    {
        const sums several = with(n);
        for (label i = 0; i < P.granular().end; ++i)
        {
            EXPECT_EQ(one.VW[i], several.VW[i]);
            EXPECT_EQ(one.FU[i], several.FU[i]);
        }
    }
}

TEST_F(pairWalk, termsComeInTheOrderOfTheirAddition)
{
    struct first : PairTerm
    {
        Particles& P;
        explicit first(Particles& particles) : P(particles) {}
        void evaluate(const PairBlock& block) override
        {
            store(lanes(3), &P.lambda[block.first]);
        }
    } a(P);
    struct second : PairTerm
    {
        Particles& P;
        explicit second(Particles& particles) : P(particles) {}
        void evaluate(const PairBlock& block) override
        {
            store(2*load(&P.lambda[block.first]), &P.w[block.first]);
        }
    } b(P);
    const Pairs pairs(P, kernel->cutOff());
    PairWalk walk(P);
    walk.add(a);
    walk.add(b);
    walk.run(pairs.list, *kernel);
    for (label i = 0; i < P.granular().end; ++i)
    {
        EXPECT_EQ(P.w[i], 6);
    }
}

TEST_F(pairWalk, fetchesAFieldOnceForAllWhoAsk)
{
    PairWalk walk(P);
    const PairWalk::Slot V = walk.neighbour("V");
    const PairWalk::Slot s = walk.neighbour("s");
    EXPECT_NE(V, s);
    EXPECT_EQ(walk.neighbour("V"), V);
    EXPECT_EQ(walk.neighbour("s"), s);
    EXPECT_EQ(walk.fields().size(), 2u);
    EXPECT_THROW(walk.neighbour("gammaPoint"), Error);
}

TEST_F(pairWalk, ofNothingDoesNothing)
{
    place(P, {}, 1);
    walked(PairWalk::Fetch::packed);
    walked(PairWalk::Fetch::direct);
}

} // namespace sph
