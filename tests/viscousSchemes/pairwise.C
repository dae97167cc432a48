#include "support/Lattice.H"
#include "support/Gradients.H"
#include "support/precision.H"
#include "viscousSchemes/ViscousScheme.H"

#include <gtest/gtest.h>

namespace sph
{

namespace
{

constexpr scalar dx = 0.1, rho0 = 1000, eta0 = 2;

struct viscousSchemes : testing::Test
{
    Particles P{dx};

    void lay(const Points& points)
    {
        place(P, points, rho0);
        for (label i = 0; i < P.granular().end; ++i)
        {
            P.eta[i] = eta0;
            P.a.set(i, vector::Zero());
        }
    }

    template<class Velocity>
    void setVelocity(const Velocity& velocity)
    {
        for (label i = 0; i < P.granular().end; ++i)
        {
            P.U.set(i, velocity(P.r[i]));
        }
    }

    void apply(const std::string& scheme, const scalar hByDx = 1.3)
    {
        const auto kernel = make<Kernel>("cubicSpline;", hByDx*dx);
        PairWalk walk(P);
        const auto model = make<ViscousScheme>(scheme, walk.particles());
        ASSERT_FALSE(model->stressCarriesShear());
        walkOnce(walk, *model, *kernel);
    }

    // Acceleration of a particle inside a lattice, over eta/rho
    vector inside
    (
        const std::string& scheme, const scalar hByDx,
        const std::function<vector(const vector&)>& velocity
    )
    {
        const label n = 13, middle = n*n/2;
        lay(squareLattice({-0.5*n*dx, -0.5*n*dx}, n, n, dx));
        setVelocity(velocity);
        apply(scheme, hByDx);
        return P.a[middle]*rho0/eta0;
    }

    // Random velocities, volumes and viscosities in disorder
    void disorder(const unsigned seed = 1)
    {
        Points points = squareLattice({1, 1}, 10, 10, dx);
        shake(points, 0.3*dx);
        lay(points);
        std::mt19937_64 engine(seed);
        std::uniform_real_distribution<scalar> number(-1, 1);
        for (label i = 0; i < P.granular().end; ++i)
        {
            P.U.set(i, {number(engine), number(engine)});
            P.eta[i] = std::exp(3*number(engine));
            P.rho[i] *= 1 + 0.2*number(engine);
            P.V[i] = P.m[i]/P.rho[i];
        }
    }
};

// u = y^2/2 and u = x^2/2 along x
vector sheared(const vector& r) { return {0.5*r.y()*r.y(), 0}; }
vector stretched(const vector& r) { return {0.5*r.x()*r.x(), 0}; }

} // namespace

TEST_F(viscousSchemes, MorrisIsTheLaplacian)
{
    for (const scalar hByDx : {1.3, 1.5, 2.0})
    {
        const vector a = inside("Morris;", hByDx, sheared);
        const vector b = inside("Morris;", hByDx, stretched);
        EXPECT_NEAR(a.x(), 1, 0.02) << hByDx;
        EXPECT_NEAR(b.x(), 1, 0.02) << hByDx;
        EXPECT_NEAR(a.y(), 0, 1e-11);
    }
}

// Fourth moments on a lattice: 0.87, 0.95, 0.97 of the limit for shear, 1.06,
// 1.03, 1.01 for extension, where the limit is 3 d2u/dx2
TEST_F(viscousSchemes, ClearyIsNearItsLimitOnALattice)
{
    const scalar hByDx[] = {1.3, 1.5, 2.0};
    const scalar shear[] = {0.87, 0.95, 0.97};
    const scalar extension[] = {1.06, 1.03, 1.01};
    for (label k = 0; k < 3; ++k)
    {
        const vector a = inside("Cleary;", hByDx[k], sheared);
        const vector b = inside("Cleary;", hByDx[k], stretched);
        EXPECT_NEAR(a.x(), shear[k], 0.01) << hByDx[k];
        EXPECT_NEAR(b.x()/3, extension[k], 0.01) << hByDx[k];
    }
}

// u = y + y^2/2, eta = eta0 exp(y/2): eta u'' + eta' u' = 3/2 eta0 at y = 0,
// and Cleary's share of it
TEST_F(viscousSchemes, feelTheGradientOfTheViscosity)
{
    const scalar hByDx[] = {1.3, 1.5, 2.0}, share[] = {0.87, 0.95, 0.97};
    const label n = 13, middle = n*n/2;
    for (label k = 0; k < 3; ++k)
    {
        for (const char* scheme : {"Morris;", "Cleary;"})
        {
            lay(squareLattice({-0.5*n*dx, -0.5*n*dx}, n, n, dx));
            const scalar y0 = P.r[middle].y();
            setVelocity([&](const vector& r)
            {
                const scalar y = r.y() - y0;
                return vector(y + 0.5*y*y, 0);
            });
            for (label i = 0; i < n*n; ++i)
            {
                P.eta[i] = eta0*std::exp(0.5*(P.r[i].y() - y0));
            }
            apply(scheme, hByDx[k]);
            const scalar expected =
                scheme[0] == 'M' ? 1.5 : 1.5*share[k];
            EXPECT_NEAR(P.a[middle].x()*rho0/eta0, expected, 0.03)
                << scheme << hByDx[k];
        }
    }
}

TEST_F(viscousSchemes, sineDecaysInProportion)
{
    const scalar k = 2*pi/(13*dx*2);
    for (const char* scheme : {"Morris;", "Cleary;"})
    {
        const label n = 13;
        inside
        (
            scheme, 1.5,
            [&](const vector& r) { return vector(std::sin(k*r.y()), 0); }
        );
        for (label j = 3; j < n - 3; ++j)
        {
            const label i = j*n + n/2;
            EXPECT_NEAR
            (
                P.a.x[i]*rho0/eta0, -k*k*P.U.x[i], 0.07*k*k
            ) << scheme << j;
        }
    }
}

TEST_F(viscousSchemes, conserveLinearMomentum)
{
    for (const char* scheme : {"Morris;", "Cleary;"})
    {
        disorder();
        apply(scheme);
        vector force = vector::Zero();
        scalar scale = 0;
        for (label i = 0; i < P.granular().end; ++i)
        {
            force += P.m[i]*P.a[i];
            scale += P.m[i]*P.a[i].norm();
        }
        EXPECT_GT(scale, 0);
        EXPECT_LT(force.norm(), rounding(1e-13, 1.5e-7)*scale) << scheme;
    }
}

TEST_F(viscousSchemes, ClearyConservesAngularMomentum)
{
    disorder();
    apply("Cleary;");
    scalar torque = 0, scale = 0;
    for (label i = 0; i < P.granular().end; ++i)
    {
        const vector r = P.r[i], f = P.m[i]*P.a[i];
        torque += r.x()*f.y() - r.y()*f.x();
        scale += r.norm()*f.norm();
    }
    EXPECT_NEAR(torque/scale, 0, rounding(1e-13, 1e-7));

    setVelocity([](const vector& r) { return vector(-r.y(), r.x()); });
    const vectorField before = P.a;
    apply("Cleary;");
    for (label i = 0; i < P.granular().end; ++i)
    {
        EXPECT_LT
        (
            (P.a[i] - before[i]).norm(), rounding(1e-12, 1e-9)*scale
        );
    }
}

TEST_F(viscousSchemes, takeEnergyOut)
{
    for (const char* scheme : {"Morris;", "Cleary;"})
    {
        for (unsigned seed = 1; seed <= 5; ++seed)
        {
            disorder(seed);
            apply(scheme);
            scalar power = 0, scale = 0;
            for (label i = 0; i < P.granular().end; ++i)
            {
                power += P.m[i]*P.a[i].dot(P.U[i]);
                scale += P.m[i]*P.a[i].norm();
            }
            EXPECT_LT(power, -0.1*scale) << scheme << seed;
        }
    }
}

// Of a pair with different viscosities: arithmetic sum (15), harmonic mean (16)
TEST_F(viscousSchemes, aPairByHand)
{
    const vector r(-0.08, -0.05), U(0.4, -0.1);
    const auto kernel = make<Kernel>("cubicSpline;", 1.3*dx);
    const scalar F = kernel->F(r.norm()), V = dx*dx;
    const vector expected[] =
    {
        V*(1 + 3)*F*U/rho0,
        8*V*2*1*3/(1 + 3)*U.dot(r)/(r.squaredNorm() + 0.01*dx*dx)*F*r/rho0
    };
    label k = 0;
    for (const char* scheme : {"Morris;", "Cleary;"})
    {
        lay({{1, 1}, vector(1, 1) - r});
        P.eta[0] = 1;
        P.eta[1] = 3;
        P.U.set(0, U);
        P.a.set(0, {5, 7});
        apply(scheme);
        EXPECT_LT
        (
            (P.a[0] - vector(5, 7) - expected[k]).norm(),
            // invSqrt, F and four products of it
            rounding(1e-12, 1e-6)*expected[k].norm()
        ) << scheme;
        ++k;
    }
}

TEST_F(viscousSchemes, nothingIsViscousWithoutViscosity)
{
    for (const char* scheme : {"Morris;", "Cleary;"})
    {
        disorder();
        for (label i = 0; i < P.granular().end; ++i)
        {
            P.eta[i] = 0;
        }
        apply(scheme);
        for (label i = 0; i < P.granular().end; ++i)
        {
            EXPECT_EQ(P.a[i].norm(), 0);
        }
    }
}

TEST_F(viscousSchemes, stressDivergenceLeavesTheShearToTheStress)
{
    PairWalk walk(P);
    const auto model = make<ViscousScheme>("stressDivergence;", walk.particles());
    EXPECT_TRUE(model->stressCarriesShear());
    EXPECT_TRUE(walk.fields().empty());
}

} // namespace sph
