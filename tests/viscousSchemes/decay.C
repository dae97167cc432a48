#include "support/Pairs.H"
#include "support/Scene.H"

#include <gtest/gtest.h>

namespace sph
{

// Slow flow of a Newtonian fluid in a periodic box, so slow that the lattice
// stays as it is: modes decay at the rates that the operators give them.
namespace
{

constexpr label n = 24;
constexpr scalar L = 1, dx = L/n, k = 2*pi/L, nu = 0.05, U0 = 1e-3;

struct decay : testing::TestWithParam<const char*>
{
    CaseText text = CaseText::plain();

    decay()
    {
        text.boundary = CaseText::periodicBox(L, L);
        text.equationOfState =
            "equationOfState linear; linearCoeffs { K 1612; tension yes; }";
        text.rheology = "rheology Newtonian; NewtonianCoeffs { eta "
          + std::to_string(nu*CaseText::rho0) + "; }";
        text.correction = "correction kernelGradient;";
        text.viscousScheme =
            std::string("viscousScheme ") + GetParam() + ';';
    }

    // -ln(E/E0)/(2 nu k^2 T), the rate over nu k^2
    template<class Velocity>
    scalar rate(const Velocity& velocity)
    {
        TestScene scene(text, dx, squareLattice({0, 0}, n, n, dx));
        Particles& P = scene.particles;
        for (label i = 0; i < P.granular().end; ++i)
        {
            P.U.set(i, U0*velocity(P.r[i]));
        }
        scene.scheme.initialise();
        const scalar E0 = scene.kineticEnergy(), dt = 5e-4;
        const label steps = 200;
        scene.run(dt, steps);
        return -std::log(scene.kineticEnergy()/E0)/(2*nu*k*k*steps*dt);
    }

    // -4 sum V F x^4/r^2 and -4 sum V F x^2 y^2/r^2 of the lattice; limits 3, 1
    std::pair<scalar, scalar> fourthMoments() const
    {
        const auto kernel = make<Kernel>("cubicSpline;", 1.3*dx);
        scalar xxxx = 0, xxyy = 0;
        for (label i = -3; i <= 3; ++i)
        {
            for (label j = -3; j <= 3; ++j)
            {
                const scalar x = i*dx, y = j*dx, r = std::hypot(x, y);
                if (r > 0)
                {
                    const scalar f = -4*dx*dx*kernel->F(r)/(r*r);
                    xxxx += f*x*x*x*x;
                    xxyy += f*x*x*y*y;
                }
            }
        }
        return {xxxx, xxyy};
    }

    // Those that act along the pair
    bool Cleary() const
    {
        const std::string scheme = GetParam();
        return
            scheme == "Cleary" || scheme == "SchwaigerCleary"
         || scheme == "SchwaigerAsPrinted";
    }
};

} // namespace

TEST_P(decay, ofAPlaneShearWave)
{
    const scalar got = rate
    (
        [](const vector& r) { return vector(std::sin(k*r.y()), 0); }
    );
    EXPECT_NEAR(got, Cleary() ? fourthMoments().second : 1, 0.05);
}

// exp(-2 nu k^2 t)
TEST_P(decay, ofTaylorAndGreensVortices)
{
    const scalar got = rate
    (
        [](const vector& r)
        {
            return vector
            (
                std::sin(k*r.x())*std::cos(k*r.y()),
                -std::cos(k*r.x())*std::sin(k*r.y())
            );
        }
    );
    const auto [xxxx, xxyy] = fourthMoments();
    EXPECT_NEAR(got/2, Cleary() ? 0.5*(xxxx - xxyy) : 1, 0.08);
}

INSTANTIATE_TEST_SUITE_P
(
    all, decay,
    testing::Values
    (
        "stressDivergence", "Morris", "Cleary", "SchwaigerMorris",
        "SchwaigerCleary", "SchwaigerAsPrinted"
    ),
    [](const auto& info) { return std::string(info.param); }
);

} // namespace sph
