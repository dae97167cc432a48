#include "setup/Filled.H"

#include "setup/checkWallDistance.H"
#include "setup/createParticles.H"
#include "setup/setFieldValues.H"

using namespace sph;

namespace
{

// Everything below y = height is wall
class testFloor : public Boundary
{
    const scalar height_;

public:
    testFloor(const dictionary& dict, const word& name, const scalar spacing)
    :
        Boundary(name, spacing),
        height_(dict.getOrDefault<scalar>("height", 0))
    {}

    scalar distance(const vector& point) const override
    {
        return point.y() - height_;
    }

    std::vector<WallParticle> wallParticles() const override
    {
        const scalar depth = 0.5*spacing();
        return {{{0, height_ - depth}, {0, 1}, depth, -1}};
    }
};

const Boundary::Add<testFloor> addFloor("testFloor", "wall of the tests");

Boundaries floorAt(const std::string& height)
{
    return Boundaries
    (
        dictionary::fromString
        (
            "bed { type testFloor; height " + height + "; }", "boundary"
        ),
        0.1
    );
}

const std::string a = "a { type box; min (0 0 0); max (1 1 0); }\n";
const std::string beside = "c { type box; min (1 0 0); max (2 1 0); }\n";

} // namespace


TEST(WallDistance, namesPatchRegionCountAndTheWorstPosition)
{
    const Filled filled("regions\n(\n" + a + ");");
    EXPECT_NO_THROW
    (
        checkWallDistance(floorAt("0"), 0.1, filled.regions)
    );
    // The lowest row at 0.05 stands 0.02 off the wall, less than 0.025
    expectError
    (
        [&]{ checkWallDistance(floorAt("0.03"), 0.1, filled.regions); },
        {
            "10 of 100 particles of region 'a'", "patch 'bed'",
            "0.02 m in front"
        },
        4
    );
    expectError
    (
        [&]{ checkWallDistance(floorAt("0.25"), 0.1, filled.regions); },
        {"30 of 100", "0.05 0), 0.2 m behind"}, 4
    );
}

TEST(Jitter, keepsOffTheWall)
{
    Filled filled("jitter 0.4; regions (" + a + ");");
    const auto still = filled.regions[0].points;
    const Boundaries floor = floorAt("0");
    jitter(filled.lattice, floor, filled.regions);

    label moved = 0;
    for (std::size_t i = 0; i < still.size(); ++i)
    {
        const vector& point = filled.regions[0].points[i];
        EXPECT_GE(point.y(), 0.025);
        moved += point != still[i];
    }
    EXPECT_GE(moved, 90);
    EXPECT_LT(moved, 100);
}

TEST(CreateParticles, massAndDensityAreUniformAndIdsUnique)
{
    const Filled filled("regions (" + a + beside + ");");
    Particles particles(0.1);
    createParticles(filled.regions, floorAt("0"), 1600, particles);
    ASSERT_EQ(particles.granular().size(), 200);
    ASSERT_EQ(particles.walls().size(), 1);
    for (label i = 0; i < 200; ++i)
    {
        EXPECT_EQ(particles.id[i], i);
        EXPECT_NEAR(particles.m[i], 16, 1e-12);
        EXPECT_EQ(particles.rho[i], 1600);
        EXPECT_EQ(particles.patch[i], -1);
    }
    const label wall = particles.walls().begin;
    EXPECT_EQ(particles.id[wall], 200);
    EXPECT_EQ(particles.patch[wall], 0);
    EXPECT_EQ(particles.r[wall], vector(0, -0.05));
    EXPECT_EQ(particles.n[wall], vector(0, 1));
    EXPECT_EQ(particles.m[particles.null()], 0);
}

TEST(FieldValues, areThoseOfTheRegionOnly)
{
    const std::string moving =
        "d { type box; min (1 0 0); max (2 1 0);"
        "fields { U (0.5 -2 0); rho 1700; s (3 4 0 -3 0 0); } }\n";
    const Filled filled("regions (" + a + moving + ");");
    Particles particles(0.1);
    createParticles(filled.regions, floorAt("0"), 1600, particles);
    setFieldValues(filled.dict, filled.regions, particles);
    EXPECT_EQ(particles.U[99], vector(0, 0));
    EXPECT_EQ(particles.rho[99], 1600);
    for (const label i : {100, 199})
    {
        EXPECT_EQ(particles.U[i], vector(0.5, -2));
        EXPECT_EQ(particles.rho[i], 1700);
        EXPECT_EQ(particles.s.xx[i], 3);
        EXPECT_EQ(particles.s.xy[i], 4);
        EXPECT_EQ(particles.s.yy[i], -3);
    }
    EXPECT_NO_THROW(filled.dict.refuseUnused());
}

TEST(FieldValues, wrongOnesAreRefused)
{
    const auto set = [](const std::string& fields)
    {
        const Filled filled
        (
            "regions (\na { type box; min (0 0 0); max (1 1 0);\n"
            "fields {\n" + fields + " } });"
        );
        Particles particles(0.1);
        createParticles(filled.regions, floorAt("0"), 1600, particles);
        setFieldValues(filled.dict, filled.regions, particles);
    };
    expectError
    (
        [&]{ set("V (0 0 0);"); }, {"Unknown field V", "rho"}, 5
    );
    expectError([&]{ set("rho -1;"); }, {"rho"}, 5);
    expectError([&]{ set("U 1;"); }, {"U"}, 5);
    expectError([&]{ set("s (1 0 0 1);"); }, {"six components"}, 5);
    expectError([&]{ set("s (1 0 2 1 0 0);"); }, {"six components"}, 5);
}

TEST(SetParticlesDict, aMisspeltEntryOfARegionIsRefused)
{
    const Filled filled
    (
        "regions (\na { type box; min (0 0 0); max (1 1 0);\n"
        "feilds { U (1 0 0); } });"
    );
    Particles particles(0.1);
    createParticles(filled.regions, floorAt("0"), 1600, particles);
    setFieldValues(filled.dict, filled.regions, particles);
    expectError
    (
        [&]{ filled.dict.refuseUnused(); }, {"feilds", "'fields'"}, 4
    );
}
