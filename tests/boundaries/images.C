#include "support/Scene.H"

#include <gtest/gtest.h>

#include <algorithm>

namespace sph
{

namespace
{

constexpr scalar dx = 0.1;

// Fields without symmetry
void fill(Particles& P, const ParticleRange& range)
{
    std::mt19937_64 engine(8);
    std::uniform_real_distribution<scalar> number(-1, 1);
    for (label i = range.begin; i < range.end; ++i)
    {
        P.U.set(i, {number(engine), number(engine)});
        const scalar xx = number(engine), xy = number(engine);
        P.s.set(i, (tensor() << xx, xy, xy, 0.3*xx).finished());
        const scalar a = number(engine), b = number(engine);
        P.gradU.set(i, (tensor() << a, b, xx, xy).finished());
        P.q[i] = number(engine);
    }
}

void refresh(TestScene& scene)
{
    std::vector<const FieldInfo*> fields;
    for (const char* name : {"U", "s", "gradU", "q", "rho"})
    {
        fields.push_back(&scene.particles.field(name));
    }
    scene.scheme.neighbourhood().refreshImages(fields);
}

// Neighbours of granular particle i within the cut-off of the kernel
label neighbourCount(TestScene& scene, const label i)
{
    const Particles& P = scene.particles;
    const PairList& list = scene.scheme.neighbourhood().granularPairs();
    const PairList::Slice& slice = list.slices()[i/laneCount];
    label count = 0;
    for (label k = 0; k < slice.n; ++k)
    {
        const label j = slice.rows[k*laneCount + i % laneCount];
        count += j != P.null()
         && (P.r[i] - P.r[j]).norm() < scene.scheme.kernel().cutOff();
    }
    return count;
}

} // namespace

TEST(symmetryPlane, mirrorsPositionsVectorsAndTensors)
{
    for (const vector& normal : {vector(1, 0), vector(0, 1), vector(1, 1)})
    {
        CaseText text = CaseText::plain();
        const vector point(0.02, 0.07), n = normal.normalized();
        text.boundary =
            "plane { type symmetryPlane; point (0.02 0.07 0); normal ("
          + std::to_string(normal.x()) + ' ' + std::to_string(normal.y())
          + " 0); }";
        Points points = squareLattice({-1, -1}, 20, 20, dx);
        shake(points, 0.2*dx);
        points.erase
        (
            std::remove_if
            (
                points.begin(), points.end(),
                [&](const vector& r) { return (r - point).dot(n) < 0; }
            ),
            points.end()
        );
        TestScene scene(text, dx, points);
        Particles& P = scene.particles;
        fill(P, P.granular());
        scene.scheme.updatePairs();
        refresh(scene);

        const scalar reach =
            scene.scheme.kernel().cutOff() + 0.2*scene.scheme.kernel().h();
        const tensor R = tensor::Identity() - 2*n*n.transpose();
        label expected = 0;
        for (label i = 0; i < P.granular().end; ++i)
        {
            const scalar d = (P.r[i] - point).dot(n);
            if (d >= reach)
            {
                continue;
            }
            ++expected;
            label image = -1;
            for (label k = P.ghosts().begin; k < P.ghosts().end; ++k)
            {
                image = P.id[k] == P.id[i] ? k : image;
            }
            ASSERT_GE(image, 0);
            EXPECT_LT((P.r[image] - P.r[i] + 2*d*n).norm(), 1e-13);
            EXPECT_LT((P.U[image] - R*P.U[i]).norm(), 1e-14);
            EXPECT_LT((P.s[image] - R*P.s[i]*R).norm(), 1e-14);
            EXPECT_LT((P.gradU[image] - R*P.gradU[i]*R).norm(), 1e-14);
            EXPECT_EQ(P.q[image], P.q[i]);
            EXPECT_EQ(P.rho[image], P.rho[i]);
            EXPECT_EQ(P.m[image], P.m[i]);
        }
        EXPECT_EQ(P.ghosts().size(), expected);
        EXPECT_GT(expected, 20);
    }
}

// U_n and s_xy change sign at a vertical plane
TEST(symmetryPlane, turnsNormalVelocityAndShear)
{
    CaseText text = CaseText::plain();
    text.boundary =
        "axis { type symmetryPlane; point (0 0 0); normal (1 0 0); }";
    TestScene scene(text, dx, {{0.05, 0.3}});
    Particles& P = scene.particles;
    P.U.set(0, {3, 4});
    P.s.set(0, (tensor() << 1, 2, 2, -1).finished());
    scene.scheme.updatePairs();
    refresh(scene);
    ASSERT_EQ(P.ghosts().size(), 1);
    const label k = P.ghosts().begin;
    EXPECT_EQ(P.U[k], vector(-3, 4));
    EXPECT_EQ(P.s[k], (tensor() << 1, -2, -2, -1).finished());
    EXPECT_LT((P.r[k] - vector(-0.05, 0.3)).norm(), 1e-15);
}

TEST(symmetryPlane, imagesMoveWithTheirSources)
{
    CaseText text = CaseText::plain();
    text.boundary =
        "axis { type symmetryPlane; point (0 0 0); normal (1 0 0); }";
    TestScene scene(text, dx, {{0.05, 0.3}});
    Particles& P = scene.particles;
    scene.scheme.updatePairs();
    const auto rebuilds = scene.scheme.neighbourhood().rebuilds();
    P.r.set(0, {0.06, 0.305});
    scene.scheme.updatePairs();
    EXPECT_EQ(scene.scheme.neighbourhood().rebuilds(), rebuilds);
    EXPECT_LT
    (
        (P.r[P.ghosts().begin] - vector(-0.06, 0.305)).norm(), 1e-15
    );
}

TEST(periodic, everyParticleOfALatticeHasTheSameNeighbourhood)
{
    CaseText text = CaseText::plain();
    text.boundary = CaseText::periodicBox(1, 0.8);
    TestScene scene(text, dx, squareLattice({0, 0}, 10, 8, dx));
    scene.scheme.updatePairs();
    // i^2 + j^2 < 2.6^2
    for (label i = 0; i < scene.particles.granular().end; ++i)
    {
        EXPECT_EQ(neighbourCount(scene, i), 20);
    }
}

TEST(periodic, imagesAreTranslatedCopies)
{
    CaseText text = CaseText::plain();
    text.boundary = CaseText::periodicBox(1, 0.8);
    Points points = squareLattice({0, 0}, 10, 8, dx);
    shake(points, 0.04);
    TestScene scene(text, dx, points);
    Particles& P = scene.particles;
    fill(P, P.granular());
    scene.scheme.updatePairs();
    refresh(scene);
    label diagonal = 0;
    for (label k = P.ghosts().begin; k < P.ghosts().end; ++k)
    {
        label i = 0;
        while (P.id[i] != P.id[k])
        {
            ++i;
        }
        const vector shift = P.r[k] - P.r[i];
        const scalar nx = std::round(shift.x());
        const scalar ny = std::round(shift.y()/0.8);
        EXPECT_LT((shift - vector(nx, 0.8*ny)).norm(), 1e-13);
        EXPECT_LE(std::abs(nx), 1);
        EXPECT_LE(std::abs(ny), 1);
        EXPECT_NE(std::abs(nx) + std::abs(ny), 0);
        diagonal += nx != 0 && ny != 0;
        EXPECT_EQ(P.U[k], P.U[i]);
        EXPECT_EQ(P.s[k], P.s[i]);
        EXPECT_EQ(P.gradU[k], P.gradU[i]);
    }
    EXPECT_GT(diagonal, 4*4);
}

TEST(periodic, whatLeavesEntersOnTheOtherSide)
{
    CaseText text = CaseText::plain();
    text.boundary = CaseText::periodicBox(1, 0.8);
    TestScene scene
    (
        text, dx, {{-0.02, 0.3}, {1.03, 0.4}, {0.5, 0.81}, {0.2, -0.03}}
    );
    scene.scheme.updatePairs();
    const vector expected[] =
        {{0.98, 0.3}, {0.03, 0.4}, {0.5, 0.01}, {0.2, 0.77}};
    const Particles& P = scene.particles;
    for (label i = 0; i < 4; ++i)
    {
        EXPECT_LT((P.r[i] - expected[P.id[i]]).norm(), 1e-14) << P.id[i];
    }
}

// A stream crosses the box many times and stays what it is
TEST(periodic, aUniformStreamDoesNotFeelTheSeam)
{
    CaseText text = CaseText::plain();
    text.boundary = CaseText::periodicBox(1, 0.8);
    TestScene scene(text, dx, squareLattice({0, 0}, 10, 8, dx));
    Particles& P = scene.particles;
    const vector U(0.7, -0.3);
    for (label i = 0; i < P.granular().end; ++i)
    {
        P.U.set(i, U);
    }
    scene.scheme.initialise();
    scene.run(0.01, 700);
    EXPECT_GT(scene.scheme.neighbourhood().rebuilds(), 30);
    for (label i = 0; i < P.granular().end; ++i)
    {
        EXPECT_LT((P.U[i] - U).norm(), 1e-9);
        EXPECT_NEAR(P.rho[i]/CaseText::rho0, 1, 1e-9);
    }
}

} // namespace sph
