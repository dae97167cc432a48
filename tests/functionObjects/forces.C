// The function object forces, over the scene of a tank.
#include "TestRun.H"

#include "scheme/WallForces.H"
#include "support/Scene.H"

using namespace sph;

namespace
{

constexpr label n = 8;
constexpr scalar dx = 0.01, L = n*dx;

CaseText tank()
{
    CaseText text;
    text.boundary =
        "bed { type noSlip; points ((-0.05 0 0) (0.15 0 0)); }"
        "side { type noSlip; points ((0.08 0 0) (0.08 0.2 0)); }"
        "axis { type symmetryPlane; point (0 0 0); normal (1 0 0); }";
    return text;
}

struct Tank
{
    TestRun files;
    TestScene scene{tank(), dx, squareLattice({0, 0}, n, n, dx)};

    // Rows at the start and after a step
    void run(const std::string& functions)
    {
        Time time
        (
            files.dir.dir(),
            dictionary::fromString
            (
                "stopAt endTime; endTime 1e-4; deltaT 1e-4;"
                "writeControl timeStep; writeInterval 1;"
                "functions {" + functions + "}"
            )
        );
        FunctionObjects objects
        (
            time.controlDict(),
            {
                files.dir.dir(), "0", {0, -9.81}, CaseText::rho0,
                scene.particles, &scene.scheme.wallForces()
            }
        );
        time.controlDict().subDict("functions").refuseUnused();
        scene.hydrostatic(9.81, L);
        scene.scheme.initialise();
        objects.execute(time, true);
        while (time.loop(1))
        {
            scene.step(time.deltaT());
            objects.execute(time);
        }
    }
};

} // namespace


TEST(forces, writesForceMomentAndTheirParts)
{
    Tank tank;
    tank.run
    (
        "both { type forces; patches (bed side); CofR (0.01 0.02 0); }"
        "bed { type forces; patches (bed); CofR (0.01 0.02 0); }"
        "side { type forces; patches (side); CofR (0.01 0.02 0); }"
        "shifted { type forces; patches (bed); CofR (0.51 0.02 0); }"
    );
    const wordList columns
    {
        "Time", "Fx", "Fy", "pressureX", "pressureY", "shearX", "shearY", "Mz"
    };
    EXPECT_EQ(tank.files.columns("both/0/both.dat"), columns);
    const auto both = tank.files.rows("both/0/both.dat");
    const auto bed = tank.files.rows("bed/0/bed.dat");
    const auto side = tank.files.rows("side/0/side.dat");
    const auto shifted = tank.files.rows("shifted/0/shifted.dat");
    ASSERT_EQ(both.size(), 2u);
    const scalar weight = CaseText::rho0*9.81*L*L;
    for (label row = 0; row < 2; ++row)
    {
        for (label c = 1; c < 8; ++c)
        {
            EXPECT_NEAR
            (
                both[row][c], bed[row][c] + side[row][c], 1e-6*weight
            ) << columns[c];
        }
        for (const label c : {1, 2})
        {
            EXPECT_NEAR
            (
                both[row][c], both[row][c + 2] + both[row][c + 4], 1e-6*weight
            );
        }
        // a centre farther to the right by 0.5 m
        EXPECT_NEAR
        (
            shifted[row][7] - bed[row][7], -0.5*bed[row][2], 1e-6*weight
        );
        EXPECT_LT(bed[row][2], -0.5*weight);
        EXPECT_GT(side[row][1], 0.1*weight);
    }
}


TEST(forces, refusesWhatIsNoWall)
{
    const auto error = [](const std::string& patches)
    {
        Tank tank;
        return errorOf
        (
            [&] { tank.run("a { type forces; patches (" + patches + "); }"); }
        );
    };
    const std::string unknown = error("bed axis");
    EXPECT_CONTAINS(unknown, "Unknown wall axis");
    EXPECT_CONTAINS(unknown, "side");
}


TEST(forces, needsARun)
{
    TestRun run;
    EXPECT_CONTAINS
    (
        errorOf([&]{ run.go("a { type forces; patches (bed); }", 0.01); }),
        "only a run has them"
    );
}
