#include "support/precision.H"
#include "support/Scene.H"
#include "support/Threads.H"

#include <gtest/gtest.h>

namespace sph
{

namespace
{

constexpr label n = 16;
constexpr scalar dx = 0.05, L = n*dx;

// A closed box of sand in random motion, without gravity
CaseText closedBox()
{
    CaseText text;
    text.g = vector::Zero();
    text.equationOfState =
        "equationOfState linear; linearCoeffs { K 1e5; }";
    text.boundary = CaseText::periodicBox(L, L);
    return text;
}

void stir(TestScene& scene)
{
    Particles& P = scene.particles;
    std::mt19937_64 engine(2);
    std::uniform_real_distribution<scalar> number(-1, 1);
    for (label i = 0; i < P.granular().end; ++i)
    {
        P.U.set(i, {0.3 + number(engine), number(engine)});
        P.rho[i] *= 1.03 + 0.01*number(engine);
    }
    scene.scheme.initialise();
}

} // namespace

class conservation : public testing::TestWithParam<std::string>
{};

TEST_P(conservation, momentumOfAClosedBoxStaysAsItIs)
{
    CaseText text = closedBox();
    if (GetParam() == "muIwithCleary")
    {
        text.rheology =
            "rheology muI; mus 0.4; mu2 0.6; I0 0.3; d 1e-3; rhos 2600;"
            "regularisation cap; etaMax 20;";
        text.viscousScheme = "viscousScheme Cleary;";
        text.artificialViscosity = "artificialViscosity Monaghan;";
        text.stabilisation = "stabilisation velocityPressureCoupling;";
        text.solution = "integrator velocityVerlet; skin 0.2;";
    }
    else if (GetParam() == "NewtonianWithMorris")
    {
        text.rheology = "rheology Newtonian; eta 20;";
        text.viscousScheme = "viscousScheme Morris;";
        text.correction = "correction kernelGradient;";
        text.turbulence = "turbulence Smagorinsky;";
    }
    TestScene scene(text, dx, squareLattice({0, 0}, n, n, dx));
    stir(scene);
    const vector before = scene.momentum();
    const scalar scale = scene.momentumScale(), E = scene.kineticEnergy();
    scene.run(scene.acousticStep(0.2), 100);
    // In single precision both forces of a pair are rounded by themselves
    EXPECT_LT
    (
        (scene.momentum() - before).norm(), rounding(1e-12, 4e-8)*scale
    );
    EXPECT_LT(scene.kineticEnergy(), 0.95*E) << "something must have happened";
}

INSTANTIATE_TEST_SUITE_P
(
    schemes, conservation,
    testing::Values("recommended", "muIwithCleary", "NewtonianWithMorris"),
    [](const auto& info) { return info.param; }
);

// Gravity alone changes the momentum of a closed box
TEST(conservationUnderGravity, momentumGrowsWithTheWeight)
{
    CaseText text = closedBox();
    text.g = {0, -2};
    TestScene scene(text, dx, squareLattice({0, 0}, n, n, dx));
    stir(scene);
    const vector before = scene.momentum();
    const scalar dt = scene.acousticStep(0.2);
    scene.run(dt, 50);
    const scalar mass = CaseText::rho0*L*L;
    const vector expected = before + mass*50*dt*text.g;
    EXPECT_LT
    (
        (scene.momentum() - expected).norm(),
        rounding(1e-12, 2e-8)*scene.momentumScale()
    );
}

TEST(threads, bitsOfARunDoNotDependOnTheirNumber)
{
    const auto result = [](const int threads)
    {
        const Threads set(threads);
        CaseText text;
        text.boundary =
            "bed { type noSlip; points ((0 0 0) (2 0 0)); }"
            "middle { type symmetryPlane; point (0 0 0); normal (1 0 0); }";
        TestScene scene(text, dx, squareLattice({0, 0}, 14, 13, dx));
        scene.hydrostatic(9.81, 13*dx);
        scene.scheme.initialise();
        scene.run(scene.acousticStep(), 120);
        EXPECT_GT(scene.scheme.neighbourhood().rebuilds(), 2);
        std::vector<scalar> bits;
        const Particles& P = scene.particles;
        for (label i = 0; i < P.granular().end; ++i)
        {
            for
            (
                const scalar value :
                {
                    scalar(P.id[i]), P.r.x[i], P.r.y[i], P.U.x[i], P.U.y[i],
                    P.rho[i], P.s.xx[i], P.s.xy[i], P.p[i], P.I[i]
                }
            )
            {
                bits.push_back(value);
            }
        }
        return bits;
    };
    const auto one = result(1);
    EXPECT_EQ(one, result(2));
    EXPECT_EQ(one, result(3));
}

} // namespace sph
