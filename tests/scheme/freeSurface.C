// The pressure-free surface of Bagnold flow, row by row: with z from the
// surface, of a layer H deep at an angle theta,
//
//     p = rho0 g z cos(theta),    s_xy = p tan(theta),
//     u = u0 (1 - (z/H)^1.5),
//     u0 = 2/3 I/d sqrt(phi g cos(theta)) H^1.5                          (40)
//
// Salehizadeh & Shafiei, Granular Matter 21:32 (2019). At the surface p, the
// shear rate and the viscosity are 0, and I is what it is everywhere.

#include "support/Scene.H"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace sph
{

namespace
{

constexpr label nx = 12, ny = 20;
constexpr scalar H = 0.02, dx = H/ny, g = 9.81, d = 5e-4, phi = 0.6;
constexpr scalar rho0 = CaseText::rho0, mus = 0.3819, mu2 = 0.6435, I0 = 0.279;
const scalar theta = 24*pi/180, mu = std::tan(theta);
const scalar I = I0*(mu - mus)/(mu2 - mu);
const scalar u0 =
    2*I/(3*d)*std::sqrt(phi*g*std::cos(theta))*std::pow(H, 1.5);

struct Row
{
    scalar z = 0;               // of its middle, from the surface [m]
    scalar p = 0, s = 0, u = 0, I = 0;
};

struct BagnoldSurface
:
    testing::TestWithParam<std::tuple<const char*, const char*>>
{
    std::unique_ptr<TestScene> scene;
    std::vector<Row> rows = std::vector<Row>(ny);   // from the bed
    label clipped = 0;              // times that a particle had no pressure

    BagnoldSurface()
    {
        const auto [name, stabilisation] = GetParam();
        const std::string law = name;
        CaseText text;
        std::ostringstream os;
        os.precision(12);
        os << "rheology " << law << "; " << law << "Coeffs { mus " << mus
            << "; mu2 " << mu2 << "; I0 " << I0 << "; d " << d << "; rhos "
            << rho0/phi << "; "
            << (law == "muI" ? "regularisation cap; etaMax 50; }" : "}");
        text.rheology = os.str();
        text.equationOfState = "equationOfState linear; linearCoeffs { K "
          + std::to_string(100*rho0*std::max(g*H, u0*u0)) + "; }";
        text.stabilisation = std::string("stabilisation ") + stabilisation
          + "; deltaSPHVolumeCoeffs { beta 1; }";
        text.g = {g*std::sin(theta), -g*std::cos(theta)};
        text.boundary =
            "ends { type periodic; point (0 0 0); translation (0.012 0 0); }"
            "bed { type noSlip; points ((0 0 0) (0.012 0 0)); }";
        scene = std::make_unique<TestScene>
        (
            text, dx, squareLattice({0, 0}, nx, ny, dx)
        );
        scene->hydrostatic(g*std::cos(theta), H);
        Particles& P = scene->particles;
        for (label i = 0; i < P.granular().end; ++i)
        {
            const scalar z = H - P.r.y[i];
            P.U.x[i] = u0*(1 - std::pow(z/H, 1.5));
            P.s.xy[i] = mu*rho0*g*std::cos(theta)*z;
        }
        scene->scheme.initialise();
    }

    // Means of the rows between two times [s]
    void run(const scalar from, const scalar to)
    {
        const scalar dt = scene->acousticStep();
        scene->run(dt, label(from/dt));
        const label steps = label((to - from)/dt);
        const Particles& P = scene->particles;
        const scalar w = 1.0/(nx*steps);
        for (label k = 0; k < steps; ++k)
        {
            scene->step(dt);
            for (label i = 0; i < P.granular().end; ++i)
            {
                Row& row = rows[P.id[i]/nx];
                row.z += w*P.r.y[i];
                row.p += w*P.p[i];
                row.s += w*P.s.xy[i];
                row.u += w*P.U.x[i];
                row.I += w*P.I[i];
                clipped += !(P.p[i] > 0);
            }
        }
        const scalar surface = rows.back().z + 0.5*dx;
        for (Row& row : rows)
        {
            row.z = surface - row.z;
        }
    }
};

} // namespace

// Of the five uppermost rows, in the mean of 0.3 s
TEST_P(BagnoldSurface, bearsItsWeightAndIsNowhereClipped)
{
    run(0.3, 0.6);
    EXPECT_EQ(clipped, 0);
    scalar p = 0, s = 0, exact = 0;
    for (label k = ny; k-- > ny - 5;)
    {
        const Row& row = rows[k];
        const scalar pk = rho0*g*std::cos(theta)*row.z;
        p += row.p;
        s += row.s;
        exact += pk;
        const scalar u = u0*(1 - std::pow(row.z/H, 1.5));
        std::printf
        (
            "z %.2f dx: p %.3f and s %.3f of the exact ones, U %+.4f u0,"
            " I %.2f of that of the flow\n",
            row.z/dx, row.p/pk, row.s/(mu*pk), (row.u - u)/u0, row.I/I
        );
        EXPECT_NEAR(row.p, pk, 0.07*pk);
        EXPECT_NEAR(row.s, mu*pk, 0.1*mu*pk);
        EXPECT_NEAR(row.u, u, 0.015*u0);

        // The gradient at the surface is that of the rows below it
        EXPECT_NEAR(row.I, I, (k == ny - 1 ? 1.5 : 0.4)*I);
    }
    EXPECT_NEAR(p, exact, 0.02*exact);
    EXPECT_NEAR(s, mu*exact, 0.03*mu*exact);
}

INSTANTIATE_TEST_SUITE_P
(
    laws, BagnoldSurface,
    testing::Combine
    (
        testing::Values("elastoViscoplasticMuI", "muI"),
        testing::Values("deltaSPH", "deltaSPHVolume")
    ),
    [](const auto& info)
    {
        return std::string(std::get<0>(info.param)) + "_"
          + std::get<1>(info.param);
    }
);

} // namespace sph
