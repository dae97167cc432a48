#include "../runTime/TestCase.H"
#include "io/caseIO.H"
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

// 60 steps, writing after step 30; and 30 steps out of what was written
void expectSameBits(const CaseText& text)
{
    const TestCase dir;
    TestScene whole(text, dx, squareLattice({0, 0}, 12, 11, dx));
    whole.boundaries.setDepths(whole.particles);
    whole.hydrostatic(9.81, 11*dx);
    whole.scheme.initialise();
    const scalar dt = whole.acousticStep(0.3);
    whole.run(dt, 31);
    writeState(whole.particles, 31*dt, dir.dir()/"31", {});
    whole.scheme.neighbourhood().reset();
    whole.run(dt, 45);

    TestScene again(text, dx);
    ASSERT_TRUE(readState(dir.dir()/"31", again.particles));
    again.boundaries.setDepths(again.particles);
    again.run(dt, 45);

    const auto expected = state(whole.particles);
    EXPECT_EQ(expected.size(), 12u*11u);
    EXPECT_EQ(state(again.particles), expected);
    scalar speed = 0;
    for (label i = 0; i < whole.particles.granular().end; ++i)
    {
        speed = std::max(speed, whole.particles.U[i].norm());
    }
    EXPECT_GT(speed, 0.01);
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

} // namespace sph
