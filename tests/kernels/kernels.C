#include "support/Pairs.H"

#include <gtest/gtest.h>

namespace sph
{

// Every kernel of the selection table, at two smoothing lengths
class kernels : public testing::TestWithParam<word>
{
protected:
    std::unique_ptr<Kernel> kernel(const scalar h) const
    {
        return make<Kernel>(GetParam() + ';', h);
    }
};

static constexpr scalar lengths[] = {0.0013, 2.7};

// 2 pi sum f r dr by Simpson's rule, knots of the splines on its points
template<class Function>
static scalar integral(const scalar radius, const Function& f)
{
    const label n = 6000;
    const scalar dr = radius/n;
    scalar sum = 0;
    for (label i = 0; i <= n; ++i)
    {
        const scalar weight = i == 0 || i == n ? 1 : (i % 2 == 1 ? 4 : 2);
        sum += weight*f(i*dr)*i*dr;
    }
    return 2*pi*sum*dr/3;
}

TEST_P(kernels, integrateToOne)
{
    for (const scalar h : lengths)
    {
        const auto k = kernel(h);
        EXPECT_NEAR
        (
            integral(k->cutOff(), [&](scalar r) { return k->W(r); }), 1, 1e-8
        );
    }
}

// -1/2 sum F r.r = 1: gradients of linear fields are exact
TEST_P(kernels, gradientHasUnitMoment)
{
    for (const scalar h : lengths)
    {
        const auto k = kernel(h);
        const auto moment = [&](scalar r) { return -0.5*k->F(r)*r*r; };
        EXPECT_NEAR(integral(k->cutOff(), moment), 1, 1e-8);
    }
}

TEST_P(kernels, gradientIsThatOfTheValue)
{
    for (const scalar h : lengths)
    {
        const auto k = kernel(h);
        const scalar e = 1e-5*h;
        for (scalar q = 0.05; q*h < 0.97*k->cutOff(); q += 0.0371)
        {
            const scalar r = q*h;
            const scalar slope = (k->W(r + e) - k->W(r - e))/(2*e);
            EXPECT_NEAR(k->F(r)*r/slope, 1, 1e-5)
                << "q = " << q;
        }
    }
}

TEST_P(kernels, vanishFromTheEdgeOfTheSupportOn)
{
    for (const scalar h : lengths)
    {
        const auto k = kernel(h);
        const scalar R = k->cutOff();
        EXPECT_GE(R, 2*h);
        EXPECT_LE(R, 3*h);
        for (const scalar f : {1.0 + 1e-12, 1.001, 1.5, 10.0, 1e6})
        {
            EXPECT_EQ(k->W(f*R), 0);
            EXPECT_EQ(k->F(f*R), 0);
        }
        EXPECT_LT(k->W(0.999*R), 1e-6*k->W(0));
        EXPECT_LT(std::abs(k->F(0.999*R)), 1e-5*std::abs(k->F(0)));
        EXPECT_GT(k->W(0.99*R), 0);
    }
}

TEST_P(kernels, arePositiveAndFallWithDistance)
{
    const auto k = kernel(1);
    for (scalar r = 0; r < 0.99*k->cutOff(); r += 0.01)
    {
        EXPECT_GT(k->W(r), k->W(r + 0.01)) << "q = " << r;
        EXPECT_GT(k->W(r), 0);
        EXPECT_LT(k->F(r), 0);
    }
}

TEST_P(kernels, gradientFactorIsFiniteAtTheCentre)
{
    for (const scalar h : lengths)
    {
        const auto k = kernel(h);
        EXPECT_TRUE(std::isfinite(k->F(0)));
        EXPECT_NEAR(k->F(1e-7*h)/k->F(0), 1, 1e-5);
    }
}

TEST_P(kernels, rowsHoldTheValuesOfTheirOwnDistances)
{
    const scalar h = 0.7;
    const auto k = kernel(h);
    const label n = 5, size = n*laneCount;
    scalar r[size];
    alignas(64) scalar rSqr[size], F[size], W[size], Falone[size];
    for (label i = 0; i < size; ++i)
    {
        r[i] = 1.2*k->cutOff()*((7*i) % size)/size;
        rSqr[i] = r[i]*r[i];
    }
    k->evaluateRows(n, rSqr, F, W);
    k->evaluateRows(n, rSqr, Falone, nullptr);
    for (label i = 0; i < size; ++i)
    {
        // At r = 0, F is a quotient of nothings
        const scalar error = (r[i] > 0 ? -1e-12 : -1e-6)*k->F(0.1*h);
        EXPECT_NEAR(F[i], k->F(r[i]), error);
        EXPECT_NEAR(W[i], k->W(r[i]), 1e-12*k->W(0));
        EXPECT_NEAR(Falone[i], F[i], error);
    }
}

INSTANTIATE_TEST_SUITE_P
(
    all, kernels,
    testing::Values("cubicSpline", "WendlandC2", "quinticSpline"),
    [](const auto& info) { return info.param; }
);

TEST(kernelValues, atTheCentre)
{
    const scalar h = 0.3, hSqr = h*h;
    EXPECT_NEAR
    (
        make<Kernel>("cubicSpline;", h)->W(0), 10/(7*pi*hSqr), 1e-12/hSqr
    );
    EXPECT_NEAR
    (
        make<Kernel>("WendlandC2;", h)->W(0), 7/(4*pi*hSqr), 1e-12/hSqr
    );
    EXPECT_NEAR
    (
        make<Kernel>("quinticSpline;", h)->W(0), 7*66/(478*pi*hSqr),
        1e-12/hSqr
    );
}

// The values (10) gives at the knots of the spline
TEST(kernelValues, cubicSplineAtItsKnots)
{
    const auto k = make<Kernel>("cubicSpline;", 1.0);
    EXPECT_NEAR(k->W(1)/k->W(0), 0.25, 1e-12);
    EXPECT_NEAR(k->W(0.5)/k->W(0), 0.71875, 1e-12);
    EXPECT_NEAR(k->W(1.5)/k->W(0), 0.03125, 1e-12);
}

TEST(kernelValues, theTableHoldsNoKernelThatIsNotTestedHere)
{
    EXPECT_EQ(SelectionTables::all().at("kernel").size(), 3u);
}

} // namespace sph
