#include "setup/createParticles.H"
#include "setup/hydrostatic.H"
#include "setup/lithostatic.H"

#include "support/Scene.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace sph;

namespace
{

constexpr scalar rho0 = 1600, K = 2e5;

const std::string sand =
    "rheology elastoViscoplasticMuI; elastoViscoplasticMuICoeffs"
    "{ mus 0.6; mu2 1.2; I0 0.3; d 1e-3; rhos 2600; }";

// A layer 2 m deep, of particles 0.1 m apart
struct Layer
{
    std::unique_ptr<EquationOfState> equationOfState = EquationOfState::New
    (
        dictionary::fromString("equationOfState linear; K 2e5;"),
        "equationOfState", rho0, 9.81
    );
    dictionary dict;
    Particles particles;

    explicit Layer
    (
        const std::string& entries, const vector& g = {0, -9.81},
        const std::string& properties = sand
    )
    :
        dict
        (
            dictionary::fromString
            (
                "spacing 0.1; regions ({ type box; min (0 0 0); max (1 2 0); });"
              + entries,
                "setParticlesDict"
            )
        )
    {
        const Quiet quiet;
        const Lattice lattice(dict);
        const auto regions = fillRegions(dict, lattice);
        particles.setSpacing(lattice.spacing());
        createParticles
        (
            regions, Boundaries(dictionary(), lattice.spacing()), rho0,
            particles
        );
        setHydrostatic(dict, g, *equationOfState, regions, particles);
        setLithostatic
        (
            dict, g, dictionary::fromString(properties, "properties"),
            *equationOfState, particles
        );
        dict.refuseUnused();
    }

    // sigma = s - p 1
    tensor sigma(const label i) const
    {
        return particles.s[i]
          - equationOfState->pressure(particles.rho[i])*tensor::Identity();
    }

    // d(S)/dz = rho(S (1 + K0)/2) gn: normal stress at depth z
    static scalar exact(const scalar z, const scalar gn, const scalar K0)
    {
        const scalar share = (1 + K0)/2;
        return K/share*std::expm1(rho0*gn*share*z/K);
    }
};

} // namespace

TEST(lithostatic, isThePressureAloneUnlessAskedFor)
{
    const Layer layer("");
    for (label i = 0; i < layer.particles.granular().end; ++i)
    {
        EXPECT_EQ(layer.particles.s[i], tensor::Zero());
    }
}

TEST(lithostatic, hasTheWeightAboveAndK0OfItSidewards)
{
    for (const scalar K0 : {0.4, 1.0, 2.0})
    {
        const Layer layer
        (
            "stress lithostatic; K0 " + std::to_string(K0) + ';'
        );
        for (label i = 0; i < layer.particles.granular().end; ++i)
        {
            const scalar S =
                Layer::exact(2 - layer.particles.r.y[i], 9.81, K0);
            const tensor sigma = layer.sigma(i);
            EXPECT_NEAR(sigma(1, 1), -S, 1e-6*S);
            EXPECT_NEAR(sigma(0, 0), -K0*S, 1e-6*S);
            EXPECT_EQ(sigma(0, 1), 0);
        }
    }
}

// Gravity tilted by 3-4-5: the shear stress carries its part along the layer
TEST(lithostatic, isInBalanceOnASlope)
{
    const Layer layer
    (
        "stress lithostatic; K0 0.8; surfaceNormal (0 1 0);",
        {0.6*9.81, -0.8*9.81}
    );
    for (label i = 0; i < layer.particles.granular().end; ++i)
    {
        const scalar S =
            Layer::exact(2 - layer.particles.r.y[i], 0.8*9.81, 0.8);
        const tensor sigma = layer.sigma(i);
        EXPECT_NEAR(sigma(1, 1), -S, 1e-6*S);
        EXPECT_NEAR(sigma(0, 0), -0.8*S, 1e-6*S);
        // d sigma_xy/dy = -rho g_x, d sigma_yy/dy = -rho g_y
        EXPECT_NEAR(sigma(0, 1), 0.75*S, 1e-6*S);
    }
}

TEST(lithostatic, entriesAreChecked)
{
    EXPECT_THROW(Layer("K0 0.5;"), IOError);
    EXPECT_THROW(Layer("stress lithostatic; K0 -1;"), IOError);
    EXPECT_THROW(Layer("stress elastic;"), IOError);
    EXPECT_THROW(Layer("stress lithostatic; hydrostatic no;"), IOError);
    EXPECT_THROW
    (
        Layer
        (
            "stress lithostatic;", {0, -9.81},
            "rheology Newtonian; NewtonianCoeffs { eta 1; }"
        ),
        IOError
    );
}
