#include "../runTime/TestCase.H"
#include "io/caseIO.H"
#include "scheme/SoundSpeed.H"
#include "support/Scene.H"

#include <gtest/gtest.h>

namespace sph
{

namespace
{

constexpr scalar dx = 0.005;

CaseText collapse()
{
    CaseText text;
    text.boundary =
        "bed { type noSlip; points ((0 0 0) (0.12 0 0)); }"
        "middle { type symmetryPlane; point (0 0 0); normal (1 0 0); }"
        "end { type freeSlip; points ((0.12 0 0) (0.12 0.1 0)); }";
    return text;
}

// All that a step starts from, in order of identity
std::map<std::int64_t, std::vector<scalar>> state(const Particles& P)
{
    std::map<std::int64_t, std::vector<scalar>> all;
    for (label i = 0; i < P.granular().end; ++i)
    {
        std::vector<scalar>& values = all[P.id[i]];
        values = {P.r.x[i], P.r.y[i], P.p[i], P.gammaDot[i], P.I[i]};
        for (const FieldInfo& info : P.fields())
        {
            for (const scalarField* c : info.components)
            {
                if (info.state)
                {
                    values.push_back((*c)[i]);
                }
            }
        }
    }
    return all;
}

// A scene whose sound speed may follow it
struct Run
{
    TestScene scene;
    SoundSpeed soundSpeed;
    scalar time;

    template<class... Args>
    Run(const scalar time, const CaseText& text, const Args&... points)
    :
        scene(text, dx, points...),
        soundSpeed
        (
            scene.material.eos(), text.g, scene.particles, time
        ),
        time(time)
    {}

    void go(const label steps)
    {
        const Quiet quiet;
        for (label k = 0; k < steps; ++k)
        {
            const scalar dt = scene.acousticStep(0.3);
            scene.step(dt);
            time += dt;
            soundSpeed.follow(time);
        }
    }
};

// Steps, writing, and some more; and these out of what was written. Returns K
// at the start, in between and at the end
std::array<scalar, 3> expectSameBits
(
    const CaseText& text, const label before = 31, const label after = 45
)
{
    const TestCase dir;
    Run whole(0, text, squareLattice({0, 0}, 12, 11, dx));
    whole.scene.boundaries.setDepths(whole.scene.particles);
    whole.scene.hydrostatic(9.81, 11*dx);
    whole.scene.scheme.initialise();
    const EquationOfState& eos = whole.scene.material.eos();
    std::array<scalar, 3> K{eos.K(), 0, 0};
    whole.go(before);
    K[1] = eos.K();
    whole.soundSpeed.write(dir.dir()/"31");
    writeState(whole.scene.particles, whole.time, dir.dir()/"31", {});
    whole.scene.scheme.neighbourhood().reset();
    const scalar time = whole.time;
    whole.go(after);
    K[2] = eos.K();

    Run again(time, text);
    EXPECT_TRUE(readState(dir.dir()/"31", again.scene.particles));
    again.scene.boundaries.setDepths(again.scene.particles);
    again.soundSpeed.read(dir.dir()/"31");
    EXPECT_EQ(again.scene.material.eos().K(), K[1]);
    again.go(after);

    const auto expected = state(whole.scene.particles);
    EXPECT_EQ(expected.size(), 12u*11u);
    EXPECT_EQ(state(again.scene.particles), expected);
    EXPECT_EQ(again.scene.material.eos().K(), K[2]);
    scalar speed = 0;
    for (label i = 0; i < whole.scene.particles.granular().end; ++i)
    {
        speed = std::max(speed, whole.scene.particles.U[i].norm());
    }
    EXPECT_GT(speed, 0.01);
    return K;
}

} // namespace

TEST(restart, isTheSameRunForTheRecommendedScheme)
{
    expectSameBits(collapse());
}

TEST(restart, isTheSameRunForAFluidWithVelocityVerlet)
{
    CaseText text = collapse();
    text.rheology =
        "rheology muI; mus 0.5; mu2 0.8; I0 0.3; d 3e-4; rhos 2600;"
        "regularisation cap; etaMax 5;";
    text.solution = "integrator velocityVerlet; skin 0.2;";
    expectSameBits(text);
}

TEST(restart, isTheSameRunForThePapersScheme)
{
    CaseText text = collapse();
    text.rheology =
        "rheology muI; mus 0.5; mu2 0.8; I0 0.3; d 3e-4; rhos 2600;"
        "regularisation cap; etaMax 5;";
    text.viscousScheme = "viscousScheme Cleary;";
    text.artificialViscosity = "artificialViscosity none;";
    text.stabilisation = "stabilisation velocityPressureCoupling;";
    text.correction = "correction kernelGradient;";
    text.turbulence = "turbulence Smagorinsky;";
    text.boundary.replace(text.boundary.find("noSlip"), 6, "Morris");
    expectSameBits(text);
}

TEST(restart, isTheSameRunWithASoundSpeedThatFollows)
{
    for (const word eos : {"linear", "Tait"})
    {
        CaseText text = collapse();
        text.equationOfState = "equationOfState " + eos
          + "; adaptive yes; KFactor 300; H 0.14;";
        const auto K = expectSameBits(text, 450, 200);
        EXPECT_LT(K[1], K[0]);
        EXPECT_LT(K[2], K[1]);
    }
}

} // namespace sph
