#include "integrators/Integrator.H"
#include "support/Lattice.H"
#include "support/Pairs.H"

#include <gtest/gtest.h>

namespace sph
{

namespace
{

// One particle whose acceleration is a(r), from rest at (1, 0)
class Motion
{
    std::unique_ptr<Integrator> integrator_;

public:
    Particles P{1};

    Motion(const std::string& keyword)
    :
        integrator_(make<Integrator>(keyword + ';'))
    {
        place(P, {{1, 0}}, 1);
    }

    template<class Acceleration>
    void go(const scalar T, const label steps, const Acceleration& a)
    {
        P.a.set(0, a(P.r[0]));
        for (label k = 0; k < steps; ++k)
        {
            integrator_->begin(P, T/steps);
            P.a.set(0, a(P.r[0]));
            integrator_->end(P, T/steps);
        }
    }
};

vector spring(const vector& r) { return -r; }

// Error at T = 1 of a spring's cosine with n steps
scalar springError(const std::string& keyword, const label n)
{
    Motion motion(keyword);
    motion.go(1, n, spring);
    return std::hypot
    (
        motion.P.r.x[0] - std::cos(1.0), motion.P.U.x[0] + std::sin(1.0)
    );
}

} // namespace

TEST(velocityVerlet, freeFallIsExact)
{
    const vector g(0.5, -9.81);
    Motion motion("velocityVerlet");
    motion.P.U.set(0, {2, 1});
    motion.go(0.7, 13, [&](const vector&) { return g; });
    const vector r = vector(1, 0) + 0.7*vector(2, 1) + 0.5*0.49*g;
    EXPECT_LT((motion.P.r[0] - r).norm(), 1e-13);
    EXPECT_LT((motion.P.U[0] - vector(2, 1) - 0.7*g).norm(), 1e-13);
}

// r = g T (T + dt)/2: half a step ahead
TEST(symplecticEuler, freeFallIsAheadByHalfAStep)
{
    Motion motion("symplecticEuler");
    motion.go(0.5, 10, [](const vector&) { return vector(0, -10); });
    EXPECT_NEAR(motion.P.r.y[0], -10*0.5*(0.5 + 0.05)/2, 1e-13);
    EXPECT_NEAR(motion.P.U.y[0], -5, 1e-13);
}

TEST(integrators, orderOfConvergence)
{
    const scalar first =
        springError("symplecticEuler", 100)/springError("symplecticEuler", 200);
    const scalar second =
        springError("velocityVerlet", 100)/springError("velocityVerlet", 200);
    EXPECT_NEAR(first, 2, 0.05);
    EXPECT_NEAR(second, 4, 0.05);
    EXPECT_LT(springError("velocityVerlet", 100), 1e-4);
}

// Symplectic: no drift of the energy over many oscillations
TEST(integrators, keepTheEnergyOfASpring)
{
    for (const char* keyword : {"symplecticEuler", "velocityVerlet"})
    {
        Motion motion(keyword);
        motion.go(2*pi*200, 200*60, spring);
        const scalar E =
            0.5*(motion.P.r[0].squaredNorm() + motion.P.U[0].squaredNorm());
        EXPECT_NEAR(E, 0.5, 0.03) << keyword;
    }
}

TEST(integrators, shiftingMovesPositionsOnlyAndAtMostATwentiethOfDx)
{
    for (const char* keyword : {"symplecticEuler", "velocityVerlet"})
    {
        const auto integrator = make<Integrator>(std::string(keyword) + ';');
        Particles P(0.2);
        place(P, {{0, 0}, {1, 0}, {2, 0}}, 1);
        P.Us.set(0, {0.3, 0.4});
        P.Us.set(1, {30, -40});
        const scalar dt = 0.01;
        integrator->begin(P, dt);
        integrator->end(P, dt);
        EXPECT_LT((P.r[0] - dt*vector(0.3, 0.4)).norm(), 1e-15);
        EXPECT_LT
        (
            (P.r[1] - vector(1, 0) - 0.05*0.2*vector(0.6, -0.8)).norm(), 1e-15
        );
        EXPECT_EQ(P.r[2], vector(2, 0));
        for (label i = 0; i < 3; ++i)
        {
            EXPECT_EQ(P.U[i], vector(0, 0));
        }
    }
}

TEST(integrators, wallsStayWhereTheyAre)
{
    for (const char* keyword : {"symplecticEuler", "velocityVerlet"})
    {
        const auto integrator = make<Integrator>(std::string(keyword) + ';');
        Particles P(1);
        P.resize(1, 1);
        const label w = P.walls().begin;
        P.r.set(w, {3, 4});
        P.U.set(w, {5, 6});
        P.a.set(w, {7, 8});
        integrator->begin(P, 0.1);
        integrator->end(P, 0.1);
        EXPECT_EQ(P.r[w], vector(3, 4));
        EXPECT_EQ(P.U[w], vector(5, 6));
    }
}

} // namespace sph
