#include "boundaries/Boundaries.H"
#include "boundaries/Motion.H"
#include "support/Scene.H"

#include <gtest/gtest.h>

namespace sph
{

namespace
{

constexpr scalar dx = 0.1;

Boundaries boundaries(const std::string& text)
{
    return Boundaries(dictionary::fromString(text, "boundary"), dx);
}

const char* bed = "bed { type noSlip; points ((0 0 0) (2 0 0)); }";

// Drawn down to the depth of the bed's layers; material on the left
std::string gate(const std::string& motion, const word& type = "freeSlip")
{
    return "gate { type " + type + "; points ((1 -0.3 0) (1 1 0)); motion {"
      + motion + "} }";
}

} // namespace

TEST(motion, followsFromTheTime)
{
    const Motion motion
    (
        dictionary::fromString("velocity (0 2 0); start 0.5; end 1.5;", "m")
    );
    const std::pair<scalar, scalar> heights[] =
        {{0, 0}, {0.5, 0}, {0.75, 0.5}, {1.5, 2}, {7, 2}};
    for (const auto& [time, height] : heights)
    {
        EXPECT_EQ(motion.displacement(time), vector(0, height)) << time;
    }
    EXPECT_EQ(motion.velocity(0.49), vector(0, 0));
    EXPECT_EQ(motion.velocity(0.5), vector(0, 2));
    EXPECT_EQ(motion.velocity(1.5), vector(0, 2));
    EXPECT_EQ(motion.velocity(1.51), vector(0, 0));
    EXPECT_FALSE(Motion().any());
    EXPECT_EQ(Motion().displacement(3), vector(0, 0));
    EXPECT_EQ(Motion().velocity(0), vector(0, 0));
}

TEST(motion, endsAfterItsTravel)
{
    const Motion motion
    (
        dictionary::fromString
        (
            "velocity (0.6 0.8 0); start 1; travel 0.5;", "m"
        )
    );
    EXPECT_LT((motion.displacement(9) - vector(0.3, 0.4)).norm(), 1e-15);
    EXPECT_EQ(motion.velocity(1.49).norm(), 1);
    EXPECT_EQ(motion.velocity(1.51).norm(), 0);
}

TEST(motion, entriesAreChecked)
{
    for
    (
        const char* wrong :
        {
            "", "velocity (0 1 0);", "velocity (0 0 0); end 1;",
            "velocity (0 1 0); end 1; travel 1;",
            "velocity (0 1 0); start 1; end 1;",
            "velocity (0 1 0); start -1; end 1;",
            "velocity (0 1 0); travel 0;",
            "velocity [0 1 0 0 0 0 0] (0 1 0); end 1;",
            "velocity (0 1 1); end 1;"
        }
    )
    {
        EXPECT_THROW(boundaries(gate(wrong)), IOError) << wrong;
    }
    const dictionary misspelt = dictionary::fromString
    (
        gate("velocity (0 1 0); end 1; begin 0;"), "boundary"
    );
    const Boundaries walls(misspelt, dx);
    EXPECT_THROW(misspelt.refuseUnused(), IOError);
}

// Whichever was listed first: the bed is whole when the gate has gone
TEST(motion, aWallThatMovesLeavesThePlaceToOneThatDoesNot)
{
    const std::string moving = gate("velocity (0 1 0); end 1;");
    for (const std::string& text : {bed + moving, moving + bed})
    {
        Boundaries patches = boundaries(text);
        patches.moveTo(1);
        const auto walls = patches.wallParticles();
        label ofBed = 0, last = 0;
        for (const WallParticle& w : walls)
        {
            ofBed += w.r.y() < 0;
            EXPECT_GE(w.patch, last) << "in the order of the patches";
            last = w.patch;
        }
        EXPECT_EQ(ofBed, 3*20);
        // Neither gap nor overlap where they meet; two for one in the gate
        EXPECT_EQ(label(walls.size()), 3*20 + 2*3*10);
    }
}

TEST(motion, particlesGoWithTheWall)
{
    Boundaries walls = boundaries
    (
        bed + gate("velocity (0.1 1.3 0); start 0.1; end 0.6;")
    );
    const auto drawn = walls.wallParticles();
    Particles P(dx);
    P.resize(3, label(drawn.size()));
    const auto expectAt = [&](const vector& displacement, const vector& U)
    {
        for (label k = 0; k < P.walls().size(); ++k)
        {
            const label w = P.walls().begin + k;
            const bool moves = drawn[k].patch == 1;
            EXPECT_LT
            (
                (
                    P.r[w] - drawn[k].r
                  - (moves ? displacement : vector(0, 0))
                ).norm(), 1e-14
            );
            EXPECT_EQ(P.Umean[w], moves ? U : vector(0, 0));
        }
    };
    for (label k = 0; k < P.walls().size(); ++k)
    {
        P.r.set(P.walls().begin + k, drawn[k].r);
        P.patch[P.walls().begin + k] = drawn[k].patch;
    }
    walls.moveTo(0.05, P);
    expectAt({0, 0}, {0, 0});
    walls.setDepths(P);
    walls.moveTo(0.3, P);
    expectAt({0.02, 0.26}, {0.1, 1.3});
    EXPECT_NO_THROW(walls.setDepths(P));
    walls.moveTo(0.7, P);
    expectAt({0.05, 0.65}, {0, 0});

    // Not those of another time
    walls.moveTo(0.3);
    EXPECT_THROW(walls.setDepths(P), Error);
}

// Many small steps lead to the very place of one large one
TEST(motion, doesNotDrift)
{
    const std::string text = gate("velocity (0.123 0.456 0); end 1;");
    Boundaries once = boundaries(text), often = boundaries(text);
    for (label k = 0; k < 1000; ++k)
    {
        often.moveTo(0.000777*k);
    }
    once.moveTo(0.777);
    often.moveTo(0.777);
    const auto a = once.wallParticles(), b = often.wallParticles();
    for (std::size_t k = 0; k < a.size(); ++k)
    {
        EXPECT_EQ(a[k].r, b[k].r);
    }
}

TEST(motion, distanceAndNetGoWithTheWall)
{
    Boundaries lid = boundaries
    (
        "lid { type noSlip; points ((1 1 0) (0 1 0));"
        " motion { velocity (0 -0.5 0); start 0; end 1; } }"
    );
    Particles P(dx);
    place(P, {{0.3, 0.79}}, 1000);
    P.U.set(0, {2, 1});
    EXPECT_NEAR(lid.distance({0.3, 0.79}).first, 0.21, 1e-14);
    EXPECT_EQ(lid.net(P), 0);

    lid.moveTo(0.4);
    EXPECT_NEAR(lid.distance({0.3, 0.79}).first, 0.01, 1e-14);
    EXPECT_EQ(lid.net(P), 1);
    EXPECT_NEAR(P.r.y[0], 0.8 - 0.25*dx, 1e-14);
    EXPECT_LT((P.U[0] - vector(2, -0.5)).norm(), 1e-14);

    // A wall that has come to rest gives no velocity
    lid.moveTo(2);
    place(P, {{0.3, 0.49}}, 1000);
    P.U.set(0, {2, 1});
    EXPECT_EQ(lid.net(P), 1);
    EXPECT_LT((P.U[0] - vector(2, 0)).norm(), 1e-14);
}

// Dummies of a rough wall carry its velocity while it moves, and add it to
// that of its surface; a smooth one gives the part normal to it
TEST(motion, isInTheVelocityOfTheDummies)
{
    const std::pair<std::string, vector> cases[] =
    {
        {"type noSlip;", {0, 2*0.7}},
        {"type noSlip; velocity (0.2 0 0);", {2*0.2, 2*0.7}},
        {"type freeSlip;", {0, 2*0.7}},
        {"type freeSlip; velocity (0.2 0 0);", {0, 2*0.7}}
    };
    for (const auto& [entries, expected] : cases)
    {
        CaseText text;
        text.boundary = "bed { points ((0 0 0) (2 0 0)); " + entries
          + " motion { velocity (0 0.7 0); start 0.1; end 0.2; } }";
        TestScene scene(text, dx, squareLattice({0, 0}, 20, 8, dx));
        const Particles& P = scene.particles;
        const label nearest = P.walls().begin + 10;
        const auto U = [&](const scalar time)
        {
            scene.boundaries.moveTo(time, scene.particles);
            scene.scheme.updatePairs();
            scene.scheme.extrapolateVelocity();
            return P.U[nearest];
        };
        const vector surface(expected.x(), 0);
        EXPECT_LT((U(0.05) - surface).norm(), 1e-14) << entries;
        EXPECT_LT((U(0.15) - expected).norm(), 1e-14) << entries;
        EXPECT_LT((U(0.25) - surface).norm(), 1e-14) << entries;
    }
}

} // namespace sph
