// Flow of fluids with a yield stress between two walls a distance 2 H apart,
// set off by a body force rho0 f. In y/H from the middle, u eta/(rho0 f H^2):
//
//     Bingham        u = (1 - Bi)^2/2                    |y| < Bi, the plug
//                    u = (1 - y^2)/2 - Bi (1 - |y|)      beyond
//     Papanastasiou  y = rate + Bi (1 - exp(-M rate)),  Bi = tau0/(rho0 f H)
//
// and no flow for Bi > 1.

#include "support/Scene.H"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace sph
{

namespace
{

constexpr label nx = 6, ny = 24;
constexpr scalar H = 0.5, dx = 2*H/ny, f = 0.1, rho = CaseText::rho0;
constexpr scalar eta = 0.1*rho, scale = f*H*H*rho/eta;

struct Channel
{
    std::unique_ptr<TestScene> scene;

    explicit Channel(const std::string& law, const scalar K)
    {
        CaseText text = CaseText::plain();
        text.rheology = "rheology " + law;
        text.equationOfState = "equationOfState linear; linearCoeffs { K "
          + std::to_string(K) + "; tension yes; }";
        text.correction = "correction kernelGradient;";
        text.artificialViscosity =
            "artificialViscosity gradientCorrected;"
            "gradientCorrectedCoeffs { alpha 0.3; chi 1; }";
        text.g = {f, 0};
        const std::string end = std::to_string(nx*dx);
        text.boundary =
            "ends { type periodic; point (0 0 0); translation ("
          + end + " 0 0); }"
            "bed { type noSlip; points ((0 -0.5 0) (" + end + " -0.5 0)); }"
            "lid { type noSlip; points ((" + end + " 0.5 0) (0 0.5 0)); }";
        scene = std::make_unique<TestScene>
        (
            text, dx, squareLattice({0, -H}, nx, ny, dx)
        );
        scene->scheme.initialise();
    }

    // Mean velocity of the row of particles that began at index row
    scalar U(const label row) const
    {
        const Particles& P = scene->particles;
        scalar sum = 0;
        for (label i = 0; i < P.granular().end; ++i)
        {
            sum += P.id[i]/nx == row ? P.U.x[i]/nx : 0;
        }
        return sum;
    }

    // RMS deviation from exact(y/H) [scale], relative to its largest value
    template<class Exact>
    scalar error(const Exact& exact) const
    {
        const Particles& P = scene->particles;
        scalar sum = 0;
        for (label i = 0; i < P.granular().end; ++i)
        {
            sum += std::pow
            (
                P.U.x[i]/scale - exact(P.r.y[i]/H), 2
            )/P.granular().size();
        }
        return std::sqrt(sum)/exact(0);
    }
};

scalar Bingham(const scalar y, const scalar Bi)
{
    const scalar z = std::max(std::abs(y), Bi);
    return 0.5*(1 - z*z) - Bi*(1 - z);
}

scalar Papanastasiou(const scalar y, const scalar Bi, const scalar M)
{
    const auto rate = [=](const scalar z)
    {
        scalar low = 0, high = 1;
        for (label k = 0; k < 60; ++k)
        {
            const scalar r = 0.5*(low + high);
            (r + Bi*(1 - std::exp(-M*r)) < z ? low : high) = r;
        }
        return high;
    };
    const label n = 200;
    scalar u = 0;
    for (label k = 0; k < n; ++k)
    {
        u += (1 - std::abs(y))/n
           *rate(std::abs(y) + (k + 0.5)*(1 - std::abs(y))/n);
    }
    return u;
}

std::string entries(const scalar Bi)
{
    std::ostringstream os;
    os << " tau0 " << Bi*rho*f*H << ';';
    return os.str();
}

std::string elastic(const scalar Bi)
{
    std::ostringstream os;
    os << "elastoViscoplasticHerschelBulkley;"
        "elastoViscoplasticHerschelBulkleyCoeffs {" << entries(Bi) << " k "
        << eta << "; }";
    return os.str();
}

} // namespace

// The profile is that of shared tables: 0.274973 in the middle for M = 10
TEST(PapanastasiouChannel, hasTheExactProfile)
{
    const scalar Bi = 0.3, M = 10;
    EXPECT_NEAR(Papanastasiou(0, Bi, M), 0.274973, 2e-5);
    EXPECT_NEAR(Papanastasiou(0.5, Bi, M), 0.228430, 2e-5);
    std::ostringstream law;
    law << "Bingham; BinghamCoeffs {" << entries(Bi) << " eta " << eta
        << "; regularisation Papanastasiou; alphar "
        << rho*f*H/(M*eta) << "; }";
    Channel channel(law.str(), 100*rho*scale*scale);
    const scalar h = channel.scene->scheme.kernel().h();
    const scalar dt = std::min
    (
        channel.scene->acousticStep(), 0.1*h*h*rho/(eta*(1 + Bi*M))
    );
    channel.scene->run(dt, label(2*H*H*rho/eta/dt));
    const scalar error = channel.error
    (
        [&](const scalar y) { return Papanastasiou(y, Bi, M); }
    );
    std::printf("RMS error %.4f of the velocity in the middle\n", error);
    EXPECT_LT(error, 0.02);
}

// With an elastic stress there is a plug, which does not deform
TEST(elasticBinghamChannel, hasThePlugOfTheExactProfile)
{
    const scalar Bi = 0.3;
    Channel channel(elastic(Bi), 100*rho*scale*scale);
    const scalar dt = channel.scene->acousticStep();
    channel.scene->run(dt, label(3*H*H*rho/eta/dt));
    const scalar error = channel.error
    (
        [&](const scalar y) { return Bingham(y, Bi); }
    );

    // Where u falls below 0.98 of the plug; spread of u within the plug
    const scalar plug = channel.U(ny/2);
    scalar width = 0, spread = 0;
    for (label row = ny/2; row < ny - 1; ++row)
    {
        const scalar y = (row + 0.5)*dx/H - 1;
        const scalar u = channel.U(row)/plug, next = channel.U(row + 1)/plug;
        spread = y < Bi ? std::max(spread, std::abs(u - 1)) : spread;
        if (u > 0.98 && next <= 0.98)
        {
            width = y + (u - 0.98)/(u - next)*dx/H;
        }
    }
    const scalar exact = Bi + std::sqrt(0.04*Bingham(0, Bi));
    std::printf
    (
        "RMS error %.4f of the velocity in the middle; 0.98 of it at %.4f H,"
        " exact %.4f; spread within the plug %.4f\n",
        error, width, exact, spread
    );
    EXPECT_LT(error, 0.03);
    EXPECT_NEAR(width, exact, 0.5*dx/H);
    EXPECT_LT(spread, 0.003);
}

// Below yield it sways, as it is let go at once, and stands: by less than the
// elastic strain allows, twice f H^2/(2 G/rho). A regularised fluid (M = 10)
// would flow at 0.05 of the scale
TEST(elasticBinghamChannel, standsBelowYield)
{
    const scalar Bi = 1.25;
    Channel channel(elastic(Bi), 100*rho*scale*scale);
    const scalar dt = channel.scene->acousticStep(), T = H*H*rho/eta;
    channel.scene->run(dt, label(T/dt));
    scalar moved = 0;
    for (label step = 0; step < label(2*T/dt); ++step)
    {
        channel.scene->step(dt);
        moved += dt*channel.U(ny/2);
    }
    const scalar sway = f*H*H*rho/channel.scene->material.rheology().G();
    const scalar creep = 2*T*scale*Papanastasiou(0, Bi, 10);
    std::printf
    (
        "moved by %.5f m; elastic sway %.5f, creep of a regularised fluid"
        " %.5f\n", moved, sway, creep
    );
    EXPECT_LT(std::abs(moved), sway);
    EXPECT_LT(sway, 0.2*creep);
}

} // namespace sph
