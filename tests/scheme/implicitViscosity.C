#include "scheme/timeStep.H"
#include "support/Scene.H"

#include <gtest/gtest.h>

#include <cmath>

namespace sph
{

// One implicit step of particles that stay where they are
namespace
{

constexpr label n = 24;
constexpr scalar L = 1, dx = L/n, k = 2*pi/L, nu = 0.05;

CaseText viscousText(const std::string& scheme, const std::string& solver)
{
    CaseText text = CaseText::plain();
    text.boundary = CaseText::periodicBox(L, L);
    text.rheology = "rheology Newtonian; NewtonianCoeffs { eta "
      + std::to_string(nu*CaseText::rho0) + "; }";
    text.correction = "correction kernelGradient;";
    text.viscousScheme = "viscousScheme " + scheme + ';';
    text.solution += solver;
    return text;
}

const std::string implicit =
    "viscousIntegration implicit; viscousSolver { tolerance 1e-11; }";

// Fills the walls' and images' values for the present state
void prepare(TestScene& scene)
{
    scene.scheme.initialise();
    Particles& P = scene.particles;
    scene.material.rheology().correct(P, P.awake(), 0);
    scene.scheme.stress();
    scene.scheme.extrapolateStress();
}

// a of the viscous force alone
void solveAlone(TestScene& scene, const scalar dt)
{
    Particles& P = scene.particles;
    for (label i = 0; i < P.granular().end; ++i)
    {
        P.a.set(i, vector::Zero());
    }
    ImplicitViscosity& implicit = *scene.scheme.implicitViscosity();
    implicit.guess(dt);
    implicit.solve(dt);
}

vector vortices(const vector& r)
{
    return
    {
        std::sin(k*r.x())*std::cos(k*r.y()),
        -std::cos(k*r.x())*std::sin(k*r.y())
    };
}

vector noise(const label i)
{
    return {std::sin(12.9898*i + 1), std::sin(78.233*i + 2)};
}

} // namespace

// Backward Euler's own amplification of Taylor and Green's vortices in a step
// a hundred times the explicit limit, 1/(1 + rate dt), rate = 2 nu k^2
TEST(implicitViscosity, dampsVorticesAsBackwardEulerDoes)
{
    for (const char* scheme : {"Morris", "Cleary"})
    {
        testing::internal::CaptureStdout();
        TestScene scene
        (
            viscousText(scheme, implicit), dx,
            squareLattice({0, 0}, n, n, dx)
        );
        Particles& P = scene.particles;
        prepare(scene);
        const scalar h = 1.3*dx, dt = 100*0.1*h*h/nu;

        // The rate of the discrete operator, from a very short step
        const auto amplification = [&](const scalar step)
        {
            for (label i = 0; i < P.granular().end; ++i)
            {
                P.U.set(i, vortices(P.r[i]));
            }
            solveAlone(scene, step);
            scalar after = 0, before = 0, off = 0;
            for (label i = 0; i < P.granular().end; ++i)
            {
                const vector U = P.U[i] + step*P.a[i];
                after += U.dot(P.U[i]);
                before += P.U[i].squaredNorm();
            }
            for (label i = 0; i < P.granular().end; ++i)
            {
                const vector U = P.U[i] + step*P.a[i];
                off = std::max(off, (U - after/before*P.U[i]).norm());
            }
            EXPECT_LT(off, 1e-9) << scheme;
            return after/before;
        };
        const scalar tiny = 1e-5/(nu*k*k);
        const scalar rate = (1/amplification(tiny) - 1)/tiny;
        const scalar got = amplification(dt);
        testing::internal::GetCapturedStdout();
        EXPECT_NEAR(got*(1 + rate*dt), 1, 1e-8) << scheme;
        // What the operators have of their limit on this lattice: decay.C
        const bool Morris = scheme == std::string("Morris");
        EXPECT_NEAR(rate/(2*nu*k*k), Morris ? 0.992 : 1.130, 0.001);
        if (Morris)
        {
            EXPECT_NEAR(got*(1 + 2*nu*k*k*dt), 1, 0.01);
        }
    }
}

// x.A y = y.A x and x.A x >= sum m x.x, in disorder, beside every kind of patch
TEST(implicitViscosity, matrixIsSymmetricAndPositive)
{
    const std::string boundaries[] =
    {
        CaseText::periodicBox(L, L),
        "ends { type periodic; point (0 0 0); translation (1 0 0); }"
        "bed { type noSlip; points ((-0.3 0 0) (1.3 0 0));"
        " velocity (0.4 0 0); }"
        "lid { type freeSlip; points ((1.3 1 0) (-0.3 1 0)); }",
        "axis { type symmetryPlane; point (0 0 0); normal (1 0 0); }"
        "box { type Morris;"
        " points ((-0.3 0 0) (1 0 0) (1 1 0) (-0.3 1 0)); }",
        "tilted { type symmetryPlane; point (0 -0.13 0); normal (-0.1 1 0); }"
        "side { type freeSlip; points ((1 -0.3 0) (1 1.3 0)); }"
    };
    for (const char* scheme : {"Morris", "Cleary"})
    {
        for (const std::string& boundary : boundaries)
        {
            CaseText text = viscousText(scheme, implicit);
            text.boundary = boundary;
            Points points = squareLattice({0, 0}, n, n, dx);
            shake(points, 0.2*dx);
            TestScene scene(text, dx, points);
            testing::internal::CaptureStdout();
            prepare(scene);
            testing::internal::GetCapturedStdout();
            Particles& P = scene.particles;
            for (label i = 0; i < P.granular().end; ++i)
            {
                P.eta[i] = 100*std::exp(3*noise(i).x());
            }
            scene.scheme.extrapolateStress();

            ViscousSystem& A = scene.scheme.implicitViscosity()->system();
            A.assemble(0.1);
            const label size = A.size();
            ViscousSystem::Vector x(size), y(size), Ax(size), Ay(size);
            for (label i = 0; i < size; ++i)
            {
                x[i] = noise(i).x();
                y[i] = noise(i).y();
            }
            A.multiply(x, Ax);
            A.multiply(y, Ay);
            EXPECT_NEAR
            (
                (x.dot(Ay) - y.dot(Ax))/(x.norm()*Ay.norm()), 0, 1e-13
            ) << scheme << boundary;
            scalar mass = 0;
            for (label i = 0; i < size; ++i)
            {
                mass += P.m[i % (size/2)]*x[i]*x[i];
            }
            EXPECT_GT(x.dot(Ax), 2*mass) << scheme << boundary;
        }
    }
}

// a - a_explicit is of first order in dt
TEST(implicitViscosity, isExplicitInShortSteps)
{
    for (const char* scheme : {"Morris", "Cleary"})
    {
        Points points = squareLattice({0, 0}, n, n, dx);
        shake(points, 0.2*dx);
        TestScene explicitScene(viscousText(scheme, ""), dx, points);
        TestScene scene(viscousText(scheme, implicit), dx, points);
        for (TestScene* s : {&explicitScene, &scene})
        {
            prepare(*s);
            for (label i = 0; i < n*n; ++i)
            {
                const label id = label(s->particles.id[i]);
                s->particles.U.set(i, noise(id));
                s->particles.p[i] = 0;
            }
            // No forces but the viscous one
            s->scheme.stress();
            s->scheme.extrapolateStress();
        }
        explicitScene.scheme.forces(0);
        const auto difference = [&](const scalar dt)
        {
            solveAlone(scene, dt);
            scalar wrong = 0, right = 0;
            for (label i = 0; i < n*n; ++i)
            {
                const vector e = explicitScene.particles.a[i];
                wrong += (scene.particles.a[i] - e).squaredNorm();
                right += e.squaredNorm();
            }
            return std::sqrt(wrong/right);
        };
        const scalar limit = 0.1*dx*dx/nu;
        const scalar a = difference(2e-3*limit), b = difference(1e-3*limit);
        EXPECT_LT(b, 5e-3) << scheme;
        EXPECT_NEAR(a/b, 2, 0.02) << scheme;
    }
}

} // namespace sph
