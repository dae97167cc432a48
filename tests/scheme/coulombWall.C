// A slab of material that is stronger than its friction on the wall: a block.
#include "io/caseIO.H"
#include "runTime/TestCase.H"
#include "support/Scene.H"

#include <gtest/gtest.h>

#include <cstdio>

namespace sph
{

namespace
{

constexpr label nx = 6, ny = 12;
constexpr scalar H = 0.06, dx = H/ny, L = nx*dx, g = 9.81, muWall = 0.3;

std::string wall(const std::string& entries)
{
    return
        "ends { type periodic; point (0 0 0); translation ("
      + std::to_string(L) + " 0 0); }"
        "bed { points ((0 0 0) (" + std::to_string(L) + " 0 0)); " + entries
      + '}';
}

const std::string coulomb = "type CoulombWall; muWall 0.3; ";

struct Slab
{
    CaseText text;
    std::unique_ptr<TestScene> scene;
    scalar dt;

    // On a wall at an angle [degrees], at a velocity along it
    Slab
    (
        const std::string& bed, const scalar degrees = 0, const scalar U = 0,
        const std::string& rheology = ""
    )
    {
        const scalar theta = degrees*pi/180;
        text.g = g*vector(std::sin(theta), -std::cos(theta));
        text.boundary = wall(bed);
        text.rheology = rheology.empty() ? text.rheology : rheology;
        scene = std::make_unique<TestScene>
        (
            text, dx, squareLattice({0, 0}, nx, ny, dx)
        );
        scene->scheme.wallForces().watch();
        scene->hydrostatic(-text.g.y(), H);
        Particles& P = scene->particles;
        for (label i = 0; i < P.granular().end; ++i)
        {
            P.U.x[i] = U;
        }
        scene->scheme.initialise();
        dt = scene->acousticStep();
    }

    // Mean velocity along the wall
    scalar U() const
    {
        return scene->momentum().x()/(CaseText::rho0*L*H);
    }

    // What happens in a time: distance, least U, and the force on the wall,
    // mean, and largest ratio of its components
    struct Record
    {
        scalar distance = 0;
        scalar least = 1e9;
        vector force = vector::Zero();
        scalar largest = 0;
    };
    Record run(const scalar time)
    {
        Record record;
        const label steps = label(time/dt);
        const label bed = scene->scheme.wallForces().walls().at("bed");
        for (label k = 0; k < steps; ++k)
        {
            scene->step(dt);
            record.distance += dt*U();
            record.least = std::min(record.least, U());
            const vector F =
                scene->scheme.wallForces().on({bed}, vector::Zero()).total();
            record.force += F/steps;
            record.largest =
                std::max(record.largest, std::abs(F.x()/F.y()));
        }
        return record;
    }
};

} // namespace

// tan 12 degrees = 0.213: the wall bears what it must, and no more. The slab
// sways as it is let go at once, undamped as on any wall
TEST(CoulombWall, holdsASlabBelowItsAngle)
{
    Slab slab(coulomb, 12);
    const auto first = slab.run(0.15), then = slab.run(0.15);
    const scalar needed = std::tan(12*pi/180);
    std::printf
    (
        "moved by %.3f dx, then %.4f dx; force %.4f of the normal one, needed"
        " %.4f\n",
        first.distance/dx, then.distance/dx, -then.force.x()/then.force.y(),
        needed
    );
    EXPECT_LT(std::abs(first.distance), 0.1*dx);
    EXPECT_LT(std::abs(then.distance), 0.02*dx);
    EXPECT_NEAR(-then.force.x()/then.force.y(), needed, 0.02*needed);
}

// a = g (sin theta - muWall cos theta), between the angle of the wall, 16.7
// degrees, and that of the material, 30.5 degrees
TEST(CoulombWall, letsASlabSlideAboveItsAngle)
{
    for (const scalar degrees : {18.0, 24.0, 29.0})
    {
        Slab slab(coulomb, degrees);
        slab.run(0.06);
        const scalar before = slab.U(), start = slab.scene->time;
        const auto record = slab.run(0.14);
        const scalar a = (slab.U() - before)/(slab.scene->time - start);
        const scalar theta = degrees*pi/180;
        const scalar exact = g*(std::sin(theta) - muWall*std::cos(theta));
        const scalar ratio = -record.force.x()/record.force.y();
        std::printf
        (
            "%g degrees: a %.4f, exact %.4f m/s2; force %.4f of the normal one,"
            " at most %.4f\n",
            degrees, a, exact, ratio, record.largest
        );
        EXPECT_NEAR(a, exact, 0.01*g*std::sin(theta));
        EXPECT_NEAR(ratio, muWall, 0.01*muWall);
        // Of elastic waves, as the wall's pressure is a mean
        EXPECT_LT(record.largest, 1.05*muWall);
    }
}

// It comes to rest after U^2/(2 muWall g), and then sways about where it
// stands: its elastic strain is released, tau = muWall rho g z, whose lowest
// mode has the frequency w = pi c_s/(2 H) and the mean speed 8/pi^2 muWall g/w
TEST(CoulombWall, stopsWhatSlidesAndReversesNothing)
{
    const scalar U = 0.2, distance = U*U/(2*muWall*g), time = U/(muWall*g);
    Slab slab(coulomb, 0, U);
    const auto first = slab.run(1.5*time), then = slab.run(2*time);
    const scalar w =
        pi/(2*H)*std::sqrt(slab.scene->material.rheology().G()/CaseText::rho0);
    const scalar sway = 8/(pi*pi)*muWall*g/w;
    const scalar spring =
        2*dx*muWall*CaseText::rho0*g*H/slab.scene->material.eos().K();
    std::printf
    (
        "stopped after %.5f m, exact %.5f; then moved by %.4f dx, not faster"
        " backwards than %.4f m/s, swaying %.4f m/s\n",
        first.distance, distance, then.distance/dx, -then.least, sway
    );
    EXPECT_NEAR(first.distance, distance, 0.02*distance);
    EXPECT_LT(std::abs(then.distance), 2*sway/w + spring);
    EXPECT_GT(then.least, -1.1*sway);
    EXPECT_NEAR(then.force.x()/then.force.y(), 0, 0.05*muWall);
}

// A belt takes it along: it slips until it has the speed of the belt
TEST(CoulombWall, dragsWhatStandsOnABelt)
{
    const scalar belt = 0.1, time = belt/(muWall*g);
    Slab slab(coulomb + "velocity (0.1 0 0);");
    slab.run(0.5*time);
    EXPECT_NEAR(slab.U(), 0.5*belt, 0.05*belt);
    slab.run(1.5*time);
    const scalar start = slab.scene->time;
    const scalar distance = slab.run(2*time).distance;
    const scalar mean = distance/(slab.scene->time - start);
    EXPECT_NEAR(mean, belt, 0.02*belt);
}

// A wall with more friction than the material is a rough one
TEST(CoulombWall, isRoughWhereTheMaterialIsWeaker)
{
    const std::string law =
        "rheology elastoViscoplasticMuI; elastoViscoplasticMuICoeffs"
        "{ mus 0.38; mu2 0.64; I0 0.279; d 0.01; rhos 2600; }";
    scalar speed[2];
    label k = 0;
    for (const char* bed : {"type noSlip;", "type CoulombWall; muWall 2;"})
    {
        Slab slab(bed, 26, 0, law);
        slab.run(0.5);
        speed[k++] = slab.U();
    }
    std::printf
    (
        "mean velocity %.4f m/s, noSlip %.4f m/s\n", speed[1], speed[0]
    );
    EXPECT_NEAR(speed[1], speed[0], 0.08*speed[0]);
}

TEST(CoulombWall, canBeGivenByItsAngle)
{
    Slab mu(coulomb, 20), angle
    (
        "type CoulombWall; frictionAngle 16.69924423;", 20
    );
    mu.run(0.02);
    angle.run(0.02);
    EXPECT_NEAR(mu.U(), angle.U(), 1e-7*mu.U());
    EXPECT_GT(mu.U(), 0);
    EXPECT_THROW(Slab(coulomb + "frictionAngle 12;"), IOError);
    EXPECT_THROW(Slab("type CoulombWall;"), IOError);
    EXPECT_THROW(Slab("type CoulombWall; muWall -1;"), IOError);
    EXPECT_THROW(Slab("type CoulombWall; frictionAngle 90;"), IOError);
}

TEST(CoulombWall, needsAStress)
{
    CaseText text;
    text.boundary = wall(coulomb);
    text.rheology = "rheology Newtonian; eta 1;";
    text.viscousScheme = "viscousScheme Morris;";
    EXPECT_THROW(TestScene(text, dx), IOError);
    text.viscousScheme = "viscousScheme stressDivergence;";
    EXPECT_NO_THROW(TestScene(text, dx));
}

// What the wall bears at rest belongs to the state
TEST(CoulombWall, isWrittenAndReadAgain)
{
    Slab slab(coulomb, 12);
    slab.run(0.02);
    const TestCase dir;
    dir.mkdir("0.1");
    writeState(slab.scene->particles, 0.1, dir.dir()/"0.1", {});
    Particles again;
    readState(dir.dir()/"0.1", again);
    const Particles& P = slab.scene->particles;
    scalar largest = 0;
    for (label w = 0; w < P.walls().size(); ++w)
    {
        const scalar tau = P.tauWall[P.walls().begin + w];
        EXPECT_EQ(again.tauWall[again.walls().begin + w], tau);
        largest = std::max(largest, tau);
    }
    EXPECT_GT(largest, 10);
}

} // namespace sph
