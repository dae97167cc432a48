#include "shifting/Shifting.H"
#include "support/Gradients.H"
#include "support/precision.H"

#include <gtest/gtest.h>

namespace sph
{

namespace
{

constexpr scalar dx = 0.05;

struct shifting : testing::Test
{
    Particles P{dx};
    std::unique_ptr<Kernel> kernel = make<Kernel>("cubicSpline;", 1.3*dx);

    // Complete support and a shear rate everywhere
    void lay(const Points& points, const scalar gammaDot = 10)
    {
        place(P, points, 1000);
        for (label i = 0; i < P.granular().end; ++i)
        {
            P.lambda[i] = 1;
            P.gammaDot[i] = gammaDot;
        }
    }

    void apply(const std::string& text = "strainRate;")
    {
        PairWalk walk(P);
        const auto model = make<Shifting>(text, walk.particles(), *kernel);
        ASSERT_TRUE(model->hasSum());
        walkOnce(walk, *model, *kernel);
    }

    // Mean distance to the nearest neighbour inside the set, and the smallest
    std::pair<scalar, scalar> nearest() const
    {
        scalar sum = 0, smallest = 1, n = 0;
        for (const label i : interior(P, 3*dx))
        {
            scalar best = 1;
            for (label j = 0; j < P.granular().end; ++j)
            {
                if (j != i)
                {
                    best = std::min(best, (P.r[i] - P.r[j]).norm());
                }
            }
            sum += best;
            smallest = std::min(smallest, best);
            ++n;
        }
        return {sum/n, smallest};
    }
};

} // namespace

TEST_F(shifting, aLatticeStaysWhereItIs)
{
    lay(squareLattice({1, 1}, 12, 12, dx));
    apply();
    for (const label i : interior(P, 3*dx))
    {
        // Terms of the size gammaDot dx cancel
        EXPECT_LT(P.Us[i].norm(), rounding(1e-10, 3e-6)*10*dx);
    }
}

TEST_F(shifting, whatIsAtRestStaysWhereItIs)
{
    Points points = squareLattice({1, 1}, 12, 12, dx);
    shake(points, 0.3*dx);
    lay(points, 0);
    apply();
    for (label i = 0; i < P.granular().end; ++i)
    {
        EXPECT_EQ(P.Us[i].norm(), 0);
    }
}

TEST_F(shifting, onlyWhereTheSupportIsComplete)
{
    Points points = squareLattice({1, 1}, 12, 12, dx);
    shake(points, 0.3*dx);
    lay(points);
    for (label i = 0; i < P.granular().end; ++i)
    {
        P.lambda[i] = i % 2 == 0 ? 0.79 : 0.81;
    }
    apply("strainRate; lambdaMin 0.8;");
    for (label i = 0; i < P.granular().end; ++i)
    {
        EXPECT_EQ(P.Us[i].norm() > 0, i % 2 == 1);
    }
}

// Us = -A h^2 gammaDot sum V [1 + 0.2 (W/W(dx))^4] grad W
TEST_F(shifting, isWhatItsFormulaSays)
{
    Points points = squareLattice({1, 1}, 12, 12, dx);
    shake(points, 0.3*dx);
    lay(points, 13);
    apply("strainRate; A 0.6;");
    const scalar h = kernel->h();
    for (label i = 0; i < P.granular().end; ++i)
    {
        vector sum = vector::Zero();
        for (label j = 0; j < P.granular().end; ++j)
        {
            const vector r = P.r[i] - P.r[j];
            const scalar ratio = kernel->W(r.norm())/kernel->W(dx);
            sum += P.V[j]*(1 + 0.2*std::pow(ratio, 4))
                *kernel->F(r.norm())*r;
        }
        const vector Us = -0.6*h*h*13*sum;
        EXPECT_LT((P.Us[i] - Us).norm(), rounding(1e-11, 3e-6)*13*dx);
    }
}

// Two that are too close in an otherwise even set move apart
TEST_F(shifting, separatesAPair)
{
    Points points = squareLattice({1, 1}, 13, 13, dx);
    const label left = 6*13 + 6, right = left + 1;
    points[left].x() += 0.2*dx;
    points[right].x() -= 0.2*dx;
    lay(points);
    apply();
    EXPECT_LT(P.Us.x[left], 0);
    EXPECT_GT(P.Us.x[right], 0);
}

TEST_F(shifting, evensOutADisorderedSet)
{
    Points points = squareLattice({1, 1}, 20, 20, dx);
    shake(points, 0.35*dx, 5);
    lay(points, 1);
    const auto before = nearest();
    for (label step = 0; step < 60; ++step)
    {
        apply();
        for (const label i : interior(P, 1.5*dx))
        {
            P.r.set(i, P.r[i] + 0.1*P.Us[i]);
        }
    }
    const auto after = nearest();
    EXPECT_GT(after.first, 1.2*before.first);
    EXPECT_GT(after.second, 1.5*before.second);
}

TEST_F(shifting, noneAsksForNothing)
{
    PairWalk walk(P);
    EXPECT_FALSE(make<Shifting>("none;", walk.particles(), *kernel)->hasSum());
    EXPECT_TRUE(walk.fields().empty());
}

} // namespace sph
