#include "support/Gradients.H"
#include "support/precision.H"

#include <gtest/gtest.h>

namespace sph
{

namespace
{

constexpr scalar dx = 0.02;
const vector gradRho(300, -170);
const tensor gradU = (tensor() << 0.3, -1.2, 2.1, 0.7).finished();

// A heap of particles in disorder with linear velocity and density
struct corrections : testing::TestWithParam<word>
{
    Particles P{dx};
    std::unique_ptr<Kernel> kernel;

    void prepare(const Points& points)
    {
        kernel = make<Kernel>(GetParam() + ';', 1.3*dx);
        place(P, points, 1000);
        for (label i = 0; i < P.granular().end; ++i)
        {
            P.U.set(i, vector(4, -3) + gradU*P.r[i]);
            P.rho[i] = 1000 + gradRho.dot(P.r[i]);
            P.V[i] = P.m[i]/P.rho[i];
        }
    }

    void disorder()
    {
        Points points = squareLattice({0.1, -0.2}, 17, 13, dx);
        shake(points, 0.35*dx, 11);
        prepare(points);
    }
};

} // namespace

// In single precision U and rho are rounded: over dx, 6e-6 and 1e-5 of their
// gradients
TEST_P(corrections, gradientsOfLinearFieldsAreExactAtSurfacesToo)
{
    const scalar little = rounding(1e-10, 5e-5);
    for (const char* correction : {"kernelGradient;", "bulkBlended;"})
    {
        disorder();
        calcGradients(P, *kernel, correction);
        label surface = 0, checked = 0;
        for (label i = 0; i < P.granular().end; ++i)
        {
            if (P.lambda[i] > 0.25)
            {
                EXPECT_LT((P.gradU[i] - gradU).norm(), little*gradU.norm());
                EXPECT_LT
                (
                    (P.gradRho[i] - gradRho).norm(), little*gradRho.norm()
                );
                ++checked;
                surface += P.lambda[i] < 0.7;
            }
        }
        EXPECT_GT(checked, 200);
        EXPECT_GT(surface, 30);
    }
}

TEST_P(corrections, divergenceAndShearRateAreThoseOfTheGradient)
{
    disorder();
    calcGradients(P, *kernel, "kernelGradient;");
    const tensor D = 0.5*(gradU + gradU.transpose())
      - 0.5*gradU.trace()*tensor::Identity();
    const scalar gammaDot = std::sqrt(2*D.squaredNorm());
    // In single precision that of U over dx
    const scalar little = rounding(1e-9, 1e-4);
    for (label i = 0; i < P.granular().end; ++i)
    {
        if (P.lambda[i] > 0.25)
        {
            EXPECT_NEAR(P.div[i], gradU.trace(), little);
            EXPECT_NEAR(P.gammaDot[i], gammaDot, little);
        }
    }
}

// M, lambda, L by brute force
TEST_P(corrections, invertTheMomentMatrix)
{
    disorder();
    calcGradients(P, *kernel, "kernelGradient;");
    // M is of the size 1, L up to 4
    const scalar little = rounding(1e-10, 2e-6);
    for (label i = 0; i < P.granular().end; ++i)
    {
        tensor M = tensor::Zero();
        for (label j = 0; j < P.granular().end; ++j)
        {
            const vector r = P.r[i] - P.r[j];
            M -= P.V[j]*kernel->F(r.norm())*r*r.transpose();
        }
        const scalar mean = 0.5*M.trace();
        const scalar lambda = mean
          - std::hypot(0.5*(M(0, 0) - M(1, 1)), M(0, 1));
        EXPECT_NEAR(P.lambda[i], lambda, rounding(1e-12, 1e-6));
        if (lambda > 0.25)
        {
            EXPECT_LT((P.L[i]*M - tensor::Identity()).norm(), little);
        }
        else
        {
            const tensor guarded = M + (0.25 - lambda)*tensor::Identity();
            EXPECT_LT((P.L[i]*guarded - tensor::Identity()).norm(), little);
        }
        EXPECT_EQ(P.w[i], 1);
    }
}

TEST_P(corrections, noneLeavesGradientsAsTheyAre)
{
    disorder();
    calcGradients(P, *kernel, "none;");
    // In single precision that of U over dx
    const scalar little = rounding(1e-11, 2e-5)*gradU.norm();
    for (label i = 0; i < P.granular().end; ++i)
    {
        EXPECT_EQ(P.L[i], tensor::Identity());
        EXPECT_EQ(P.w[i], 0);
        tensor G = tensor::Zero();
        for (label j = 0; j < P.granular().end; ++j)
        {
            const vector r = P.r[i] - P.r[j];
            G += P.V[j]*kernel->F(r.norm())*(P.U[j] - P.U[i])*r.transpose();
        }
        EXPECT_LT((P.gradU[i] - G).norm(), little);
        EXPECT_NEAR(P.div[i], G.trace(), little);
    }
}

// Bulk: corrected, front: not, between: in proportion
TEST_P(corrections, bulkBlendedTakesTheCorrectedDivergenceInTheBulk)
{
    disorder();
    calcGradients(P, *kernel, "none;");
    const scalarField plain = P.div;
    calcGradients(P, *kernel, "bulkBlended; lambda0 0.5; lambda1 0.9;");
    label between = 0;
    for (label i = 0; i < P.granular().end; ++i)
    {
        const scalar w =
            std::min(std::max((P.lambda[i] - 0.5)/0.4, 0.0), 1.0);
        EXPECT_NEAR(P.w[i], w, 1e-14);
        EXPECT_NEAR
        (
            P.div[i], w*P.gradU[i].trace() + (1 - w)*plain[i],
            1e-11*gradU.norm()
        );
        between += w > 0 && w < 1;
    }
    EXPECT_GT(between, 10);
}

TEST_P(corrections, isolatedParticlesStayFinite)
{
    // One alone, two together, three in a row
    prepare
    ({
        {0, 0}, {1, 0}, {1 + dx, 0}, {2, 0}, {2 + dx, dx}, {2 + 2*dx, 2*dx}
    });
    for (const char* correction : {"kernelGradient;", "bulkBlended;", "none;"})
    {
        calcGradients(P, *kernel, correction);
        for (label i = 0; i < P.granular().end; ++i)
        {
            EXPECT_TRUE(P.L[i].allFinite()) << correction << ' ' << i;
            EXPECT_TRUE(P.gradU[i].allFinite());
            EXPECT_TRUE(P.gradRho[i].allFinite());
            EXPECT_TRUE(std::isfinite(P.div[i]));
            EXPECT_LE(P.L[i].norm(), 4*std::sqrt(2) + 1e-9);
        }
        EXPECT_NEAR(P.lambda[0], 0, 1e-14);
        EXPECT_EQ(P.gradU[0], tensor::Zero());
    }
}

// Inside a lattice the moment is that of the kernel: the identity nearly
TEST_P(corrections, lambdaTellsInsideFromSurface)
{
    prepare(squareLattice({0, 0}, 16, 16, dx));
    for (label i = 0; i < P.granular().end; ++i)
    {
        P.V[i] = dx*dx;
    }
    calcGradients(P, *kernel, "none;");
    for (const label i : interior(P, 4*dx))
    {
        EXPECT_NEAR(P.lambda[i], 1, 0.03);
    }
    EXPECT_LT(P.lambda[8], 0.7);
    EXPECT_LT(P.lambda[0], P.lambda[8]);
}

INSTANTIATE_TEST_SUITE_P
(
    all, corrections,
    testing::Values("cubicSpline", "WendlandC2", "quinticSpline"),
    [](const auto& info) { return info.param; }
);

TEST(correctionEntries, areChecked)
{
    EXPECT_THROW
    (
        make<Correction>("bulkBlended; lambda0 0.9; lambda1 0.6;"),
        IOError
    );
    EXPECT_THROW
    (
        make<Correction>("bulkBlended; lambda0 -0.1;"), IOError
    );
}

} // namespace sph
