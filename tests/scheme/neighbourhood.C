#include "support/Scene.H"

#include <gtest/gtest.h>

#include <algorithm>

namespace sph
{

namespace
{

constexpr scalar dx = 0.1;

// Every pair within the cut-off must be in the list, whatever moved since
void expectComplete(TestScene& scene)
{
    const Particles& P = scene.particles;
    const scalar reach = scene.scheme.kernel().cutOff();
    const PairList& list = scene.scheme.neighbourhood().granularPairs();
    label pairs = 0;
    for (label i = 0; i < P.granular().end; ++i)
    {
        std::vector<label> found, expected;
        const PairList::Slice& slice = list.slices()[i/laneCount];
        for (label k = 0; k < slice.n; ++k)
        {
            const label j = slice.rows[k*laneCount + i % laneCount];
            if (j != P.null() && (P.r[i] - P.r[j]).norm() < reach)
            {
                found.push_back(j);
            }
        }
        for
        (
            const ParticleRange& range :
            {P.granular(), P.walls(), P.ghosts()}
        )
        {
            for (label j = range.begin; j < range.end; ++j)
            {
                if (j != i && (P.r[i] - P.r[j]).norm() < reach)
                {
                    expected.push_back(j);
                }
            }
        }
        std::sort(found.begin(), found.end());
        ASSERT_EQ(found, expected) << i;
        pairs += label(found.size());
    }
    EXPECT_GT(pairs, 1000);
}

CaseText openBox()
{
    CaseText text = CaseText::plain();
    text.boundary =
        "bed { type noSlip; points ((0 0 0) (2 0 0)); }"
        "axis { type symmetryPlane; point (0 0 0); normal (1 0 0); }"
        "ends { type symmetryPlane; point (2 0 0); normal (-1 0 0); }";
    return text;
}

} // namespace

TEST(neighbourhood, isCompleteWithWallsAndImages)
{
    Points points = squareLattice({0, 0}, 20, 9, dx);
    shake(points, 0.4*dx);
    TestScene scene(openBox(), dx, points);
    scene.scheme.updatePairs();
    EXPECT_GT(scene.particles.ghosts().size(), 50);
    expectComplete(scene);

    // Wall particles see the material and its images alone
    const Particles& P = scene.particles;
    const PairList& list = scene.scheme.neighbourhood().wallPairs();
    EXPECT_EQ(list.first(), P.walls().begin);
    EXPECT_GT(list.pairCount(), 100);
    for (const PairList::Slice& slice : list.slices())
    {
        for (label k = 0; k < slice.n*laneCount; ++k)
        {
            const label j = slice.rows[k];
            EXPECT_TRUE(j == P.null() || P.patch[j] == -1);
        }
    }
}

TEST(neighbourhood, staysCompleteWhileParticlesMove)
{
    Points points = squareLattice({0.1, 0.1}, 18, 9, dx);
    shake(points, 0.3*dx);
    TestScene scene(openBox(), dx, points);
    Particles& P = scene.particles;
    scene.scheme.updatePairs();
    const auto before = scene.scheme.neighbourhood().rebuilds();
    std::mt19937_64 engine(6);
    std::uniform_real_distribution<scalar> number(-1, 1);
    for (label step = 0; step < 60; ++step)
    {
        for (label i = 0; i < P.granular().end; ++i)
        {
            P.r.set
            (
                i,
                P.r[i] + 0.03*dx*vector(number(engine), number(engine))
            );
        }
        scene.scheme.updatePairs();
        expectComplete(scene);
    }
    const auto rebuilds = scene.scheme.neighbourhood().rebuilds() - before;
    EXPECT_GT(rebuilds, 3);
    EXPECT_LT(rebuilds, 60);
}

// One particle that moves more than half of the skin is enough
TEST(neighbourhood, rebuildsWhenDisplacementsDifferByTheSkin)
{
    TestScene scene(openBox(), dx, squareLattice({0, 0}, 20, 9, dx));
    Particles& P = scene.particles;
    Neighbourhood& neighbourhood = scene.scheme.neighbourhood();
    const scalar skin = 0.2*scene.scheme.kernel().h();
    EXPECT_TRUE(neighbourhood.update());
    EXPECT_FALSE(neighbourhood.update());
    P.r.x[77] += 0.99*skin;
    EXPECT_FALSE(neighbourhood.update());
    P.r.x[77] += 0.02*skin;
    EXPECT_TRUE(neighbourhood.update());
    EXPECT_FALSE(neighbourhood.update());
    neighbourhood.reset();
    EXPECT_TRUE(neighbourhood.update());
}

TEST(neighbourhood, sortsParticlesThatAreNearTogether)
{
    Points points = squareLattice({0, 0}, 20, 9, dx);
    std::shuffle(points.begin(), points.end(), std::mt19937(3));
    TestScene scene(openBox(), dx, points);
    Particles& P = scene.particles;
    for (label i = 0; i < P.granular().end; ++i)
    {
        P.U.set(i, P.r[i]);
    }
    scene.scheme.updatePairs();
    scalar mean = 0;
    for (label i = 0; i + 1 < P.granular().end; ++i)
    {
        mean += (P.r[i + 1] - P.r[i]).norm()/P.granular().end;
        EXPECT_EQ(P.U[i], P.r[i]) << "state moves with its particle";
        EXPECT_EQ(P.r[i], points[P.id[i]]);
    }
    EXPECT_LT(mean, 5*dx);
}

} // namespace sph
