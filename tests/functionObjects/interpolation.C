#include "functionObjects/Interpolation.H"

#include "../deposit/heaps.H"

#include <gtest/gtest.h>

#include <random>

namespace sph
{

namespace
{

constexpr scalar dx = 0.01, L = 0.2, H = 0.1;

// A column whose particles have left their places, with p linear
struct Disordered
{
    Particles particles{dx};

    Disordered()
    {
        heaps::place(particles, heaps::column(L, H, dx));
        std::mt19937_64 engine(1);
        std::uniform_real_distribution<scalar> number(-0.2*dx, 0.2*dx);
        for (label i = 0; i < particles.granular().end; ++i)
        {
            particles.r.x[i] += number(engine);
            particles.r.y[i] += number(engine);
            particles.p[i] = exact(particles.r[i]);
        }
    }

    static scalar exact(const vector& r)
    {
        return 700 + 3000*r.x() - 15000*r.y();
    }

    scalar at(const vector& point) const
    {
        return Interpolation(particles).at(point, {&particles.p})[0];
    }
};

} // namespace

TEST(interpolation, linearFieldsAreExactInsideAtEdgesAndInCorners)
{
    const Disordered scene;
    for
    (
        const vector& point :
        {
            vector(0.1, 0.05), vector(0.0537, 0.0311), vector(0, 0.05),
            vector(0.1, H), vector(0.1, 0), vector(0, 0), vector(L, H)
        }
    )
    {
        EXPECT_NEAR(scene.at(point), Disordered::exact(point), 1e-9)
            << point.transpose();
    }
}

TEST(interpolation, thereIsNothingOutsideTheMaterial)
{
    const Disordered scene;
    for
    (
        const vector& point :
        {
            vector(0.1, H + 1.2*dx), vector(-1.2*dx, 0.05), vector(5, -5)
        }
    )
    {
        EXPECT_TRUE(std::isnan(scene.at(point))) << point.transpose();
    }
}

// A row of particles tells nothing of the other direction: means of both sides
TEST(interpolation, meanWhereTheNeighboursLieOnALine)
{
    Particles row(dx);
    heaps::place(row, heaps::column(L, dx, dx));
    for (label i = 0; i < row.granular().end; ++i)
    {
        row.p[i] = i;
    }
    const Interpolation interpolation(row);
    const scalar between = interpolation.at({0.1, 0.5*dx}, {&row.p})[0];
    EXPECT_NEAR(between, 9.5, 1e-9);
    const scalar above = interpolation.at({0.1, 0.6*dx}, {&row.p})[0];
    EXPECT_NEAR(above, 9.5, 1e-9);
}

} // namespace sph
