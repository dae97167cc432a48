#include "support/precision.H"
#include "support/Scene.H"

#include <gtest/gtest.h>

namespace sph
{

namespace
{

constexpr label n = 20;
constexpr scalar dx = 0.005, H = n*dx, g = 9.81;

// 20 by 20 particles between smooth sides, which carry nothing of the weight
CaseText tank()
{
    CaseText text;
    text.boundary =
        "bed { type noSlip; points ((-0.015 0 0) (0.115 0 0)); }"
        "left { type freeSlip; points ((0 0.15 0) (0 0 0)); }"
        "right { type freeSlip; points ((0.1 0 0) (0.1 0.15 0)); }";
    return text;
}

} // namespace

// Mean error of p in the middle fifth of the height, and its roughness: the
// deviation from the neighbours' mean, carried to the same height
static std::pair<scalar, scalar> errorAndRoughness(const Particles& P)
{
    scalar error = 0, roughness = 0, count = 0;
    for (label i = 0; i < P.granular().end; ++i)
    {
        if (P.r.y[i] < 0.4*H || P.r.y[i] > 0.6*H)
        {
            continue;
        }
        error += P.p[i]/(P.rho[i]*g*(H - P.r.y[i])) - 1;
        scalar mean = 0, neighbours = 0;
        for (label j = 0; j < P.granular().end; ++j)
        {
            if (j != i && (P.r[j] - P.r[i]).norm() < 1.2*dx)
            {
                mean += P.p[j] + P.rho[i]*g*(P.r.y[j] - P.r.y[i]);
                ++neighbours;
            }
        }
        roughness += std::pow(mean/neighbours/P.p[i] - 1, 2);
        ++count;
    }
    return {error/count, std::sqrt(roughness/count)};
}

TEST(columnAtRest, keepsItsPressureAndStaysAtRest)
{
    TestScene scene(tank(), dx, squareLattice({0, 0}, n, n, dx));
    scene.hydrostatic(g, H);
    scene.scheme.initialise();
    const scalar dt = scene.acousticStep();
    const Particles& P = scene.particles;
    for (label tenth = 1; tenth <= 10; ++tenth)
    {
        scene.run(dt, label(0.02/dt));
        const auto [error, roughness] = errorAndRoughness(P);
        EXPECT_LT(std::abs(error), 0.02) << tenth;
        EXPECT_LT(roughness, 0.005) << tenth;
    }
    for (label i = 0; i < P.granular().end; ++i)
    {
        EXPECT_GT(P.r.y[i], 0.3*dx);
    }
    EXPECT_EQ(scene.netHits, 0);
    const scalar mgH = CaseText::rho0*H*H*g*H;
    EXPECT_LT(scene.kineticEnergy(), 1e-8*mgH);
}

TEST(columnAtRest, carriesItsWeightOnTheBed)
{
    TestScene scene(tank(), dx, squareLattice({0, 0}, n, n, dx));
    scene.hydrostatic(g, H);
    scene.scheme.initialise();
    const scalar dt = scene.acousticStep();
    scene.run(dt, label(0.1/dt));
    const Particles& P = scene.particles;
    scalar bed = 0, area = 0;
    for (label w = P.walls().begin; w < P.walls().end; ++w)
    {
        const vector r = P.r[w];
        if (P.depth[w] < dx && r.y() < 0 && r.x() > 0.02 && r.x() < 0.08)
        {
            bed += P.p[w];
            ++area;
        }
    }
    // First layer of dummies: dx/2 below the bed
    EXPECT_NEAR(bed/area/(CaseText::rho0*g*(H + 0.5*dx)), 1, 0.05);
}

// A half column with a mirror is half of the whole one, step for step
TEST(symmetry, halfAColumnWithAMirrorIsHalfOfTheWhole)
{
    CaseText whole, half;
    half.boundary =
        "bed { type noSlip; points ((0 0 0) (0.2 0 0)); }"
        "middle { type symmetryPlane; point (0 0 0); normal (1 0 0); }";
    whole.boundary = "bed { type noSlip; points ((-0.2 0 0) (0.2 0 0)); }";
    const label nx = 10, ny = 12;
    Points right = squareLattice({0, 0}, nx, ny, dx), both = right;
    for (const vector& r : right)
    {
        both.push_back({-r.x(), r.y()});
    }
    TestScene a(half, dx, right), b(whole, dx, both);
    for (TestScene* scene : {&a, &b})
    {
        scene->hydrostatic(g, ny*dx);
        scene->scheme.initialise();
    }
    const scalar dt = a.acousticStep();
    const label steps = 150;
    a.run(dt, steps);
    b.run(dt, steps);

    std::vector<label> place(both.size());
    for (label i = 0; i < b.particles.granular().end; ++i)
    {
        place.at(b.particles.id[i]) = i;
    }
    const Particles& A = a.particles;
    const Particles& B = b.particles;
    scalar fastest = 0;
    // In single precision the order of pairs counts, in all steps
    const scalar rLittle = rounding(1e-9, 3e-7)*dx;
    const scalar ULittle = rounding(1e-9, 2e-7);
    const scalar rhoLittle = rounding(1e-9, 1e-7)*CaseText::rho0;
    const scalar sLittle = rounding(1e-9, 3e-6)*CaseText::rho0*g*H;
    for (label i = 0; i < A.granular().end; ++i)
    {
        const label j = place.at(A.id[i]);
        const label mirrored = place.at(A.id[i] + right.size());
        EXPECT_LT((A.r[i] - B.r[j]).norm(), rLittle);
        EXPECT_LT((A.U[i] - B.U[j]).norm(), ULittle);
        EXPECT_NEAR(A.rho[i], B.rho[j], rhoLittle);
        EXPECT_LT((A.s[i] - B.s[j]).norm(), sLittle);
        EXPECT_NEAR(B.r.x[mirrored], -B.r.x[j], rLittle);
        fastest = std::max(fastest, A.U[i].norm());
    }
    EXPECT_GT(fastest, 0.05);
}

TEST(collapse, aColumnSpreadsAndStops)
{
    CaseText text;
    text.boundary =
        "bed { type noSlip; points ((0 0 0) (0.3 0 0)); }"
        "middle { type symmetryPlane; point (0 0 0); normal (1 0 0); }";
    const label nx = 12, ny = 12;
    TestScene scene(text, dx, squareLattice({0, 0}, nx, ny, dx));
    scene.hydrostatic(g, ny*dx);
    scene.scheme.initialise();
    const scalar dt = scene.acousticStep(), tc = std::sqrt(ny*dx/g);
    scalar peak = 0;
    for (label k = 0; k < label(8*tc/dt); ++k)
    {
        scene.step(dt);
        peak = std::max(peak, scene.kineticEnergy());
    }
    EXPECT_LT(scene.kineticEnergy(), 1e-3*peak);
    scalar xMax = 0, yMax = 0;
    for (label i = 0; i < scene.particles.granular().end; ++i)
    {
        xMax = std::max(xMax, scene.particles.r.x[i]);
        yMax = std::max(yMax, scene.particles.r.y[i]);
    }
    // Neither a block nor a puddle: run-out near 1.2 of the length
    EXPECT_GT(xMax, 1.5*nx*dx);
    EXPECT_LT(xMax, 3.5*nx*dx);
    EXPECT_GT(yMax, 0.6*ny*dx);
    EXPECT_LT(yMax, ny*dx);
}

} // namespace sph
