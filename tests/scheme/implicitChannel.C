#include "support/Scene.H"

#include <gtest/gtest.h>

#include <cmath>

namespace sph
{

// Flow between two walls at rest, set off by a body force G:
//
//     u = G/(2 nu) y (H - y) - sum_odd 4 G H^2/(nu pi^3 j^3) sin(j pi y/H)
//                              exp(-nu (j pi/H)^2 t)
namespace
{

constexpr label rows = 20;
constexpr scalar H = 1, dx = H/rows, nu = 1, G = 0.1;

scalar exact(const scalar y, const scalar t)
{
    scalar u = G/(2*nu)*y*(H - y);
    for (label j = 1; j < 60; j += 2)
    {
        u -= 4*G*H*H/(nu*std::pow(j*pi, 3))*std::sin(j*pi*y/H)
           *std::exp(-nu*std::pow(j*pi/H, 2)*t);
    }
    return u;
}

struct channel : testing::TestWithParam<std::tuple<const char*, const char*>>
{
    CaseText text = CaseText::plain();

    channel()
    {
        const auto [wallType, scheme] = GetParam();
        text.rheology = "rheology Newtonian; NewtonianCoeffs { eta 1612; }";
        text.equationOfState =
            "equationOfState linear; linearCoeffs { K 1612; tension yes; }";
        text.correction = "correction kernelGradient;";
        text.viscousScheme = std::string("viscousScheme ") + scheme + ';';
        text.g = {G, 0};
        const std::string wall = std::string("{ type ") + wallType + ';';
        text.boundary =
            "ends { type periodic; point (0 0 0); translation (0.5 0 0); }"
            "bed " + wall + "points ((-0.3 0 0) (0.8 0 0)); }"
            "lid " + wall + "points ((0.8 1 0) (-0.3 1 0)); }";
    }

    // Velocities of the particles by their id after time t
    std::vector<vector> run
    (
        const std::string& solution, const scalar dt, const scalar t,
        std::vector<scalar>& heights
    )
    {
        text.solution = "integrator symplecticEuler; skin 0.2;" + solution;
        TestScene scene(text, dx, squareLattice({0, 0}, rows/2, rows, dx));
        Particles& P = scene.particles;
        scene.scheme.initialise();
        const label n = P.granular().end;

        // The first kick of an implicit run is without viscosity
        const bool implicit = scene.scheme.implicitViscosity();
        scene.run(dt, label(std::lround(t/dt)) + implicit);
        std::vector<vector> U(n);
        heights.resize(n);
        for (label i = 0; i < n; ++i)
        {
            U[P.id[i]] = P.U[i];
            heights[P.id[i]] = P.r.y[i];
        }
        return U;
    }
};

} // namespace

TEST_P(channel, startsInLongStepsAsInShortOnes)
{
    const std::string implicit =
        "viscousIntegration implicit; viscousSolver { tolerance 1e-9; }";
    // The viscous limit (33) is 8.5e-5 s
    const scalar dt = 4e-3;
    for (const scalar t : {0.1, 0.4})
    {
        std::vector<scalar> y;
        const auto U = run(implicit, dt, t, y);
        const auto V = run("", dt/20, t, y);
        scalar wrong = 0, apart = 0, right = 0;
        for (std::size_t i = 0; i < U.size(); ++i)
        {
            const scalar u = exact(y[i], t);
            wrong += std::pow(U[i].x() - u, 2);
            apart += std::pow(U[i].x() - V[i].x(), 2);
            right += u*u;
        }
        // Against explicit steps 20 times shorter: the first order of backward
        // Euler. Against the exact profile: dummy walls at 20 rows, alike in
        // both.
        EXPECT_LT(std::sqrt(apart/right), 0.02) << t;
        EXPECT_LT(std::sqrt(wrong/right), 0.1) << t;
    }
}

// Dragged by its lid: u = U_lid y/H
TEST_P(channel, followsAMovingWall)
{
    const scalar ULid = 0.01;
    text.g = vector::Zero();
    text.boundary += "lid { velocity (0.01 0 0); }";
    std::vector<scalar> y;
    const auto U = run("viscousIntegration implicit;", 4e-3, 0.6, y);
    scalar wrong = 0;
    for (std::size_t i = 0; i < U.size(); ++i)
    {
        wrong += std::pow(U[i].x()/ULid - y[i]/H, 2);
    }
    EXPECT_LT(std::sqrt(wrong/U.size()), 0.02);
}

INSTANTIATE_TEST_SUITE_P
(
    implicitViscosity, channel,
    testing::Combine
    (
        testing::Values("noSlip", "Morris"),
        testing::Values("Morris", "Cleary")
    ),
    [](const auto& info)
    {
        return std::string(std::get<0>(info.param)) + "Wall"
          + std::get<1>(info.param);
    }
);

} // namespace sph
