// Profiles across a layer, and reference data beside them.
#include "deposit/LayerProfile.H"
#include "deposit/ReferenceCurve.H"
#include "heaps.H"
#include "primitives/error.H"
#include "../runTime/TestCase.H"

#include <cmath>
#include <gtest/gtest.h>

using namespace sph;

TEST(LayerProfile, isExactForALinearFieldHoweverBinsAreCut)
{
    Particles P(0.01);
    heaps::place(P, heaps::column(0.2, 0.1, 0.01));
    const vector n(0.6, 0.8), origin(0.01, -0.02);
    for (label i = 0; i < P.granular().end; ++i)
    {
        P.rho[i] *= 1 + 0.3*std::sin(7*i);
        P.p[i] = 5 - 3*(P.r[i] - origin).dot(n);
    }
    for (const scalar width : {0.003, 0.01, 0.037})
    {
        const LayerProfile layer(P, {&P.p}, origin, n, width);
        scalar volume = 0, before = -1;
        for (const LayerProfile::Bin& bin : layer.bins())
        {
            EXPECT_NEAR(bin.values[0], 5 - 3*bin.z, 1e-12);
            EXPECT_GT(bin.z, before);
            before = bin.z;
            volume += bin.volume;
        }
        scalar all = 0;
        for (label i = 0; i < P.granular().end; ++i)
        {
            all += P.m[i]/P.rho[i];
        }
        EXPECT_NEAR(volume, all, 1e-12*all);
    }
}

// Cubic between the rows: exact for a cubic, of fourth order otherwise
TEST(ReferenceCurve, isCubicBetweenItsPoints)
{
    ReferenceCurve cubic;
    const auto f = [](scalar x) { return 1 - x + 2*x*x - 3*x*x*x; };
    for (const scalar x : {0.0, 0.4, 0.5, 1.1, 1.7, 2.0})
    {
        cubic.add(x, f(x));
    }
    for (const scalar x : {0.4, 0.45, 0.6, 1.0, 1.3, 1.69})
    {
        EXPECT_NEAR(cubic(x), f(x), 1e-12);
    }
    EXPECT_TRUE(cubic.covers(2) && cubic.covers(0));
    EXPECT_FALSE(cubic.covers(2.01) || cubic.covers(-0.01));

    const auto error = [](const label n)
    {
        ReferenceCurve curve;
        for (label k = -1; k <= n + 1; ++k)
        {
            curve.add(scalar(k)/n, std::exp(scalar(k)/n));
        }
        return std::abs(curve(0.5/n) - std::exp(0.5/n));
    };
    EXPECT_NEAR(error(10)/error(20), 16, 2);
}
