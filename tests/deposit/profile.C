#include "deposit/Profile.H"
#include "heaps.H"
#include "primitives/error.H"

#include <gtest/gtest.h>
#include <random>

using namespace sph;

static const BedLine flat{{0, 0}, {1, 0}};

// Particles of unlike mass at random places, with x from -0.3 to 0.5
static void scatter(Particles& particles)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<scalar> x(-0.3, 0.5), y(0, 0.1), f(0.3, 3);
    std::vector<vector> points;
    for (label i = 0; i < 500; ++i)
    {
        points.emplace_back(x(random), y(random));
    }
    heaps::place(particles, points);
    for (label i = 0; i < 500; ++i)
    {
        particles.m[i] *= f(random);
    }
}


TEST(Profile, conservesTheVolumeForAnyBinAndOrigin)
{
    Particles particles(0.004);
    scatter(particles);
    scalar volume = 0;
    for (label i = 0; i < particles.granular().size(); ++i)
    {
        volume += particles.m[i]/heaps::rho0;
    }
    for (const scalar binWidth : {0.0005, 0.0037, 0.008, 0.1, 3.0})
    {
        for (const scalar origin : {0.0, 0.0123, -7.7})
        {
            const BedLine bed{{origin, 0}, {1, 0}};
            const Profile profile(particles, bed, heaps::rho0, binWidth);
            EXPECT_NEAR(profile.volume(), volume, 1e-13*volume)
                << "bin " << binWidth << " origin " << origin;
        }
    }
}


TEST(Profile, thicknessOfAColumnIsItsHeight)
{
    Particles particles(0.01);
    heaps::place(particles, heaps::column(0.2, 0.3, 0.01));
    const Profile profile(particles, flat, heaps::rho0, 0.02);
    for (scalar x = 0.01; x < 0.2; x += 0.02)
    {
        EXPECT_NEAR(profile.h(profile.bin(x)), 0.3, 1e-12) << "x = " << x;
    }
    EXPECT_NEAR(profile.h(profile.bin(0.21)), 0, 1e-12);
    EXPECT_NEAR(profile.h(profile.bin(-0.01)), 0, 1e-12);
}


TEST(Profile, volumeCountsMassNotDensity)
{
    Particles particles(0.01);
    heaps::place(particles, heaps::column(0.2, 0.3, 0.01));
    const Profile loose(particles, flat, heaps::rho0, 0.02);
    for (label i = 0; i < particles.granular().size(); ++i)
    {
        particles.rho[i] *= 1.1;
    }
    const Profile dense(particles, flat, heaps::rho0, 0.02);
    EXPECT_EQ(loose.volume(), dense.volume());
}


TEST(Profile, aParticleThatCrossesAnEdgeMakesNoStep)
{
    Particles particles(0.01);
    heaps::place(particles, {{0, 0}});
    scalar before = -1;
    for (scalar x = -0.015; x < 0.015; x += 1e-4)
    {
        particles.r.x[0] = x;
        const Profile profile(particles, flat, heaps::rho0, 0.02);
        const scalar right = profile.h(profile.bin(0.01));
        if (before >= 0)
        {
            EXPECT_LE(std::abs(right - before), 1.01*1e-4*0.01/0.02);
        }
        before = right;
    }
    EXPECT_NEAR(before, 0.005, 1e-12);
}


TEST(Profile, mirroredParticlesHaveTheMirroredProfile)
{
    Particles particles(0.004);
    scatter(particles);
    const Profile one(particles, flat, heaps::rho0, 0.008);
    for (label i = 0; i < particles.granular().size(); ++i)
    {
        particles.r.x[i] *= -1;
    }
    const Profile other(particles, flat, heaps::rho0, 0.008);
    for (scalar x = -0.5; x < 0.5; x += 0.008)
    {
        EXPECT_NEAR(one.h(one.bin(x)), other.h(other.bin(-x)), 1e-12);
    }
}


TEST(Profile, followsTheDirectionOfAnIncline)
{
    const scalar angle = 22*pi/180;
    const vector along(std::cos(angle), -std::sin(angle));
    const vector up(std::sin(angle), std::cos(angle));
    const vector origin(0.4, 1.7);

    std::vector<vector> points = heaps::triangle(0.4, 0.1, 0.005);
    Particles level(0.005), inclined(0.005);
    heaps::place(level, points);
    for (vector& point : points)
    {
        point = origin + point.x()*along + point.y()*up;
    }
    heaps::place(inclined, points);

    const Profile one(level, flat, heaps::rho0, 0.01);
    const Profile other(inclined, {origin, along}, heaps::rho0, 0.01);
    for (scalar x = 0.005; x < 0.4; x += 0.01)
    {
        EXPECT_NEAR(one.h(one.bin(x)), other.h(other.bin(x)), 1e-10);
    }
}


TEST(Profile, movingMeanIsTheThicknessAroundAPlace)
{
    Particles particles(0.004);
    scatter(particles);
    const Profile coarse(particles, flat, heaps::rho0, 0.008);
    for (const label n : {1, 4, 5})
    {
        const Profile fine(particles, flat, heaps::rho0, 0.008/n);
        const Profile mean = fine.movingMean(n);
        EXPECT_NEAR(mean.volume(), coarse.volume(), 1e-13);
        for (label bin = 0; bin < coarse.size(); ++bin)
        {
            const scalar x = coarse.x(bin);
            EXPECT_NEAR(mean.x(mean.bin(x)), x, 1e-12);
            EXPECT_NEAR(mean.h(mean.bin(x)), coarse.h(bin), 1e-12);
        }
    }
}


TEST(Profile, refusesWhatHasNoSurface)
{
    Particles particles(0.01);
    EXPECT_THROW(Profile(particles, flat, heaps::rho0, 0.02), Error);
    heaps::place(particles, {{0, 0}, {1e9, 0}});
    EXPECT_THROW(Profile(particles, flat, heaps::rho0, 0.02), Error);
    particles.r.x[1] = std::nan("");
    EXPECT_THROW(Profile(particles, flat, heaps::rho0, 0.02), Error);
}
