// Sleepers beside a wall that begins to move.
#include "SleepScene.H"

namespace sph
{

namespace
{

constexpr scalar dx = 0.005, g = 9.81;
constexpr label nx = 40, ny = 10;

// Sand between two sides, the right one of which moves from 5 s on
CaseText tank(const std::string& velocity)
{
    CaseText text;
    text.equationOfState =
        "equationOfState linear; linearCoeffs { KFactor 100; H 0.05; }";
    text.boundary =
        "bed { type noSlip; points ((-0.015 0 0) (0.4 0 0)); }"
        "left { type freeSlip; points ((0 0.08 0) (0 0 0)); }"
        "gate { type freeSlip; points ((0.2 0 0) (0.2 0.08 0));"
        " motion { velocity " + velocity + "; start 5; travel 0.1; } }";
    return text;
}

// Asleep, and the wall about to move
std::unique_ptr<SleepScene> asleep(const std::string& velocity)
{
    auto scene = std::make_unique<SleepScene>
    (
        tank(velocity), dx, squareLattice({0, 0}, nx, ny, dx)
    );
    scene->hydrostatic(g, ny*dx);
    scene->scheme.initialise();
    const scalar dt = scene->acousticStep();
    scene->runUntilAsleep(dt, nx*ny, nx*ny, 3);
    EXPECT_LT(scene->time, 5);
    scene->time = 5 - 1.5*dt;
    scene->step(dt);
    EXPECT_EQ(scene->asleep(), nx*ny) << "it has not moved yet";
    return scene;
}

} // namespace

// However slowly
TEST(sleepWalls, aWallThatMovesWakesWhatIsBesideIt)
{
    const auto scene = asleep("(1e-5 0 0)");
    scene->run(scene->acousticStep(), 12);
    const Particles& P = scene->particles;
    label awake = 0;
    for (label i = 0; i < P.granular().end; ++i)
    {
        const bool near = P.r.x[i] > 0.2 - 2*dx;
        const bool far = P.r.x[i] < 0.2 - 10*dx;
        EXPECT_FALSE(near && P.asleep[i] == 1) << P.r[i].transpose();
        EXPECT_FALSE(far && P.asleep[i] < 1) << P.r[i].transpose();
        awake += P.asleep[i] < 1;
    }
    EXPECT_GT(awake, 2*ny);
}

// The sand that slept behind a gate flows when it lifts, as it does awake
TEST(sleepWalls, theSandBehindAGateFlowsWhenItLifts)
{
    const auto scene = asleep("(0 1.3 0)");
    const scalar dt = scene->acousticStep();
    scene->run(dt, label(0.2/dt));
    scalar front = 0;
    const Particles& P = scene->particles;
    for (label i = 0; i < P.granular().end; ++i)
    {
        front = std::max(front, P.r.x[i]);
    }
    EXPECT_GT(front, 0.2 + 5*dx);
    EXPECT_EQ(scene->netHits, 0);
}

} // namespace sph
