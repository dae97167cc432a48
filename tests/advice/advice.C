#include "advice/MeasuredScene.H"
#include "advice/knownLimits.H"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace sph
{

namespace
{

const char* const text = R"(
kind column;  aspect 2;  duration 10;  reference "the finest run";
runs
(
    { setting fast; across 40; particles 3200; time 40; error 1;
      front 0.5; height -1; }
    { setting fast; across 10; particles 200; time 1; error 3;
      front 1; height -1; }
    { setting fast; across 20; particles 800; time 6; error 2;
      front -6; height 1; }
    { setting slow; across 10; particles 200; time 2; error 4; }
);
)";

MeasuredScene measured()
{
    return {"tall", dictionary::fromString(text)};
}

// 0.2 m high, 0.1 m long
CaseScene column()
{
    CaseScene scene{};
    scene.kind = "column";
    scene.height = 0.2;
    scene.length = 0.1;
    scene.area = 0.02;
    scene.spacing = 0.005;
    scene.duration = 5;
    scene.KFactor = 100;
    return scene;
}

} // namespace

TEST(advice, timesGoWithParticlesAndSteps)
{
    const MeasuredScene tall = measured();
    CaseScene scene = column();
    EXPECT_NEAR(scene.across(), 20, 1e-12);
    EXPECT_NEAR(scene.particles(10), 200, 1e-9);
    // As many particles, half as long
    EXPECT_NEAR(tall.timeOf(scene, tall.runs()[0]), 0.5, 1e-12);
    scene.area *= 3;
    EXPECT_NEAR(tall.timeOf(scene, tall.runs()[0]), 1.5, 1e-12);
}

// A coarse run that is right by chance, while a finer one is not, is no promise
TEST(advice, aRunIsWithinAnErrorIfAllFinerOnesAre)
{
    const MeasuredScene tall = measured();
    ASSERT_NE(tall.coarsestWithin("fast", 2), nullptr);
    EXPECT_EQ(tall.coarsestWithin("fast", 2)->across, 40);
    EXPECT_EQ(tall.coarsestWithin("fast", 7)->across, 10);
    EXPECT_EQ(tall.coarsestWithin("fast", 0.5), nullptr);
    EXPECT_EQ(tall.coarsestWithin("none", 10), nullptr);
    // Without front and height it is the error that counts
    EXPECT_EQ(tall.coarsestWithin("slow", 3), nullptr);
    EXPECT_EQ(tall.coarsestWithin("slow", 5)->across, 10);
}

TEST(advice, nearIsWhatHasTheSameShape)
{
    const MeasuredScene tall = measured();
    CaseScene scene = column();
    EXPECT_NEAR(tall.distance(scene), 0, 1e-12);
    scene.length = 0.4;
    EXPECT_NEAR(tall.distance(scene), std::log(4), 1e-12);
    scene.kind = "incline";
    EXPECT_FALSE(std::isfinite(tall.distance(scene)));
}

TEST(advice, namesTheLimitsThatACaseLiesIn)
{
    const auto says = [](const CaseScene& scene, const std::string& part)
    {
        const auto limits = knownLimits(scene);
        return std::any_of
        (
            limits.begin(), limits.end(),
            [&](const std::string& limit)
            {
                return limit.find(part) != std::string::npos;
            }
        );
    };
    EXPECT_TRUE(knownLimits(column()).empty());
    CaseScene scene = column();
    scene.spacing = 0.02;
    scene.KFactor = 20;
    scene.slope = std::atan(0.7);
    scene.slow = Friction{0.3, 0};
    scene.fast = Friction{0.6, 0};
    EXPECT_TRUE(says(scene, "coarse: 5 particles"));
    EXPECT_TRUE(says(scene, "soft: K is 20"));
    EXPECT_TRUE(says(scene, "steep"));
    EXPECT_FALSE(says(scene, "falls"));
    EXPECT_FALSE(says(scene, "little friction"));
    scene.slow->mu = 0.05;
    EXPECT_TRUE(says(scene, "little friction"));
    scene.falls = true;
    EXPECT_TRUE(says(scene, "falls"));
    scene.KFactor = 2e4;
    EXPECT_TRUE(says(scene, "stiff"));
}

} // namespace sph
