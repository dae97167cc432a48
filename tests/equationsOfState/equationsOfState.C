#include "equationsOfState/EquationOfState.H"
#include "support/Lattice.H"
#include "support/Pairs.H"

#include <gtest/gtest.h>

namespace sph
{

static constexpr scalar rho0 = 1500, g = 9.81;

class equationsOfState : public testing::TestWithParam<word>
{
protected:
    std::unique_ptr<EquationOfState> eos(const std::string& entries) const
    {
        return make<EquationOfState>(GetParam() + ';' + entries, rho0, g);
    }
};

TEST_P(equationsOfState, stiffnessIsGivenEitherWay)
{
    EXPECT_EQ(eos("K 2e5;")->K(), 2e5);
    const auto scaled = eos("KFactor 50; H 0.2;");
    EXPECT_NEAR(scaled->K(), 50*rho0*g*0.2, 1e-9);
    EXPECT_NEAR(scaled->c(), std::sqrt(50*g*0.2), 1e-12);
    EXPECT_EQ(scaled->rho0(), rho0);
    EXPECT_NEAR(eos("H 0.2;")->K(), 100*rho0*g*0.2, 1e-9);
}

TEST_P(equationsOfState, densityIsTheInverseOfPressure)
{
    const auto e = eos("K 1e5;");
    for (const scalar p : {0.0, 1.0, 1e3, 5e4})
    {
        EXPECT_NEAR(e->pressure(e->density(p)), p, 1e-9*(p + 1e2));
        EXPECT_GE(e->density(p), rho0);
    }
}

// dp/drho = c^2 = K/rho0 at rest
TEST_P(equationsOfState, soundSpeedIsTheSlopeAtRest)
{
    const auto e = eos("K 1e5;");
    const scalar d = 1e-6*rho0;
    const scalar slope = e->pressure(rho0 + d)/d;
    EXPECT_NEAR(slope/(e->c()*e->c()), 1, 1e-4);
    EXPECT_NEAR(e->c()*e->c()*rho0, 1e5, 1e-7);
}

TEST_P(equationsOfState, bearsNoTensionUnlessItIsTold)
{
    EXPECT_EQ(eos("K 1e5;")->pressure(0.99*rho0), 0);
    EXPECT_EQ(eos("K 1e5; tension no;")->pressure(0.5*rho0), 0);
    EXPECT_LT(eos("K 1e5; tension yes;")->pressure(0.99*rho0), -900);
}

TEST_P(equationsOfState, fieldsAreAsSingleValues)
{
    const auto e = eos("K 1e5;");
    Particles P(1);
    place(P, squareLattice({0, 0}, 5, 4, 1), rho0);
    for (label i = 0; i < 20; ++i)
    {
        P.rho[i] = rho0*(0.97 + 0.01*i);
        P.p[i] = -1;
    }
    e->correct({2, 17}, P.rho, P.p);
    for (label i = 0; i < 20; ++i)
    {
        const bool within = i >= 2 && i < 17;
        EXPECT_NEAR(P.p[i], within ? e->pressure(P.rho[i]) : -1, 1e-9) << i;
    }
}

TEST_P(equationsOfState, entriesAreChecked)
{
    EXPECT_THROW(eos("K -1;"), IOError);
    EXPECT_THROW(eos("KFactor 100;"), IOError);
    EXPECT_THROW(eos("KFactor 100; H 0;"), IOError);
    EXPECT_THROW
    (
        make<EquationOfState>(GetParam() + "; H 0.1;", rho0, 0.0), IOError
    );
}

TEST_P(equationsOfState, anotherKTakesTheSoundSpeedAlong)
{
    const auto e = eos("KFactor 100; H 0.1; adaptive yes;");
    EXPECT_TRUE(e->adaptive());
    EXPECT_EQ(e->KFactor(), 100);
    EXPECT_FALSE(eos("KFactor 100; H 0.1;")->adaptive());
    EXPECT_NEAR(e->K(), 100*rho0*g*0.1, 1e-9);
    e->setK(3e5);
    EXPECT_EQ(e->K(), 3e5);
    EXPECT_NEAR(e->c(), std::sqrt(3e5/rho0), 1e-12);
    EXPECT_NEAR(e->pressure(e->density(1e3)), 1e3, 1e-8);
    EXPECT_NEAR(e->density(1e3), rho0*(1 + 1e3/3e5), 0.1);
}

TEST_P(equationsOfState, adaptiveNeedsAScaleAndNoTension)
{
    EXPECT_THROW(eos("adaptive yes;"), IOError);
    EXPECT_THROW(eos("adaptive often; H 0.1;"), IOError);
    EXPECT_THROW(eos("adaptive yes; KFactor 5; H 0.1;"), IOError);
    const auto text = [&](const std::string& entries)
    {
        try
        {
            eos(entries);
        }
        catch (const IOError& error)
        {
            return error.block();
        }
        return std::string();
    };
    EXPECT_NE(text("adaptive yes; K 1e5;").find("KFactor"), std::string::npos);
    EXPECT_NE
    (
        text("adaptive yes; H 0.1; tension yes;").find("tension"),
        std::string::npos
    );
    EXPECT_NO_THROW(eos("adaptive no; K 1e5; tension yes;"));
}

INSTANTIATE_TEST_SUITE_P
(
    all, equationsOfState, testing::Values("linear", "Tait"),
    [](const auto& info) { return info.param; }
);

TEST(equationOfStateValues, linear)
{
    const auto e = make<EquationOfState>("linear; K 1e5;", rho0, g);
    EXPECT_NEAR(e->pressure(1.02*rho0), 2e3, 1e-9);
}

TEST(equationOfStateValues, Tait)
{
    const auto e = make<EquationOfState>("Tait; K 7e5; gamma 7;", rho0, g);
    EXPECT_NEAR(e->pressure(1.1*rho0), 1e5*(std::pow(1.1, 7) - 1), 1e-6);
    // gamma = 1 is the linear law
    const auto one = make<EquationOfState>("Tait; K 1e5; gamma 1;", rho0, g);
    EXPECT_NEAR(one->pressure(1.02*rho0), 2e3, 1e-8);
}

} // namespace sph
