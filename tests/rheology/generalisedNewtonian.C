#include "Specimens.H"

namespace sph
{

static const tensor general = (tensor() << 3, -1, 5, -0.5).finished();

static tensor deviator(const tensor& gradU)
{
    return 0.5*(gradU + gradU.transpose())
      - 0.5*gradU.trace()*tensor::Identity();
}

TEST(Newtonian, stressIsTwiceEtaD)
{
    Specimens one("Newtonian; eta 0.7;");
    one.deform(0, general);
    one.correct(1e-3);
    EXPECT_LT((one.P.s[0] - 1.4*deviator(general)).norm(), 1e-13);
    EXPECT_EQ(one.P.eta[0], 0.7);
    EXPECT_FALSE(one.rheology->elastic());
    EXPECT_EQ(one.rheology->G(), 0);
}

TEST(Newtonian, etaIsChecked)
{
    EXPECT_THROW(Specimens("Newtonian;"), IOError);
    EXPECT_THROW(Specimens("Newtonian; eta -1;"), IOError);
    EXPECT_THROW(Specimens("Newtonian; eta [0 2 -1 0 0 0 0] 1;"), IOError);
}

TEST(muI, viscosityIsFrictionOverRate)
{
    const Sand sand;
    for (const scalar P : {5.0, 400.0, 2e4})
    {
        for (const scalar rate : {1e-3, 0.4, 30.0, 5e3})
        {
            Specimens one
            (
                "muI; regularisation cap; etaMax 1e12;" + sand.entries()
            );
            // P = p + q
            one.P.p[0] = 1.5*P;
            one.P.q[0] = -0.5*P;
            one.shear(0, rate);
            one.correct(1e-3);
            const scalar I = sand.inertialNumber(rate, P);
            EXPECT_NEAR(one.P.I[0]/I, 1, 1e-12);
            EXPECT_NEAR(one.P.eta[0]/(sand.mu(I)*P/rate), 1, 1e-12);
            EXPECT_NEAR(one.P.s.xy[0]/(sand.mu(I)*P), 1, 1e-12);
            EXPECT_EQ(one.P.s.xx[0], 0);
        }
    }
}

TEST(muI, stressIsTwiceEtaD)
{
    Specimens one("muI; regularisation cap; etaMax 20;" + Sand().entries());
    one.P.p[0] = 100;
    one.deform(0, general);
    one.correct(1e-3);
    EXPECT_GT(one.P.eta[0], 0);
    EXPECT_LT
    (
        (one.P.s[0] - 2*one.P.eta[0]*deviator(general)).norm(),
        1e-12*one.P.s[0].norm()
    );
}

TEST(muI, capLimitsTheViscosityAtSlowRates)
{
    const Sand sand;
    const scalar P = 100, etaMax = 20;
    scalar before = etaMax;
    label capped = 0;
    for (const scalar rate : {0.0, 1e-6, 1.0, 1.9, 2.0, 2.5, 10.0, 100.0})
    {
        Specimens one
        (
            "muI; regularisation cap; etaMax 20;" + sand.entries()
        );
        one.P.p[0] = P;
        one.shear(0, rate);
        one.correct(1e-3);
        const scalar raw = rate == 0 ? 1e300
          : sand.mu(sand.inertialNumber(rate, P))*P/rate;
        EXPECT_NEAR(one.P.eta[0], std::min(raw, etaMax), 1e-11*etaMax);
        EXPECT_LE(one.P.eta[0], before);
        before = one.P.eta[0];
        capped += raw > etaMax;
    }
    EXPECT_GE(capped, 3);
    EXPECT_LT(before, 0.1*etaMax);
}

// (39), written down once more
TEST(muI, PapanastasiouIsThatOfThePaper)
{
    const Sand sand;
    const scalar P = 300, alphar = 2, alphas = 0.5;
    const scalar xi = sand.I0/(sand.d*std::sqrt(sand.rhos));
    for (const scalar rate : {1e-3, 0.1, 2.0, 50.0})
    {
        Specimens one
        (
            "muI; regularisation Papanastasiou; alphar 2; alphas 0.5;"
          + sand.entries()
        );
        one.P.p[0] = P;
        one.shear(0, rate);
        one.correct(1e-3);
        const scalar eta =
            sand.mus*P*(1 - std::exp(-rate/alphar))/rate
          + (sand.mu2 - sand.mus)*P/(xi*std::sqrt(P) + rate)
           *rate/std::sqrt(rate*rate + alphas*alphas);
        EXPECT_NEAR(one.P.eta[0]/eta, 1, 1e-10) << rate;
    }
}

TEST(muI, PapanastasiouTendsToTheLawAndStaysFiniteAtRest)
{
    const Sand sand;
    const scalar P = 300, alphar = 1e-3;
    Specimens two
    (
        "muI; regularisation Papanastasiou; alphar 1e-3; alphas 1e-6;"
      + sand.entries(),
        3
    );
    for (label i = 0; i < 3; ++i)
    {
        two.P.p[i] = P;
    }
    two.shear(0, 4);
    two.shear(1, 0);
    two.shear(2, 1e-13);
    two.correct(1e-3);
    const scalar mu = sand.mu(sand.inertialNumber(4, P));
    EXPECT_NEAR(two.P.eta[0]/(mu*P/4), 1, 1e-9);
    EXPECT_NEAR(two.P.eta[1]/(sand.mus*P/alphar), 1, 1e-6);
    EXPECT_NEAR(two.P.eta[2]/(sand.mus*P/alphar), 1, 1e-6);
}

TEST(muI, bearsNoStressWithoutPressure)
{
    for (const char* law : {"cap; etaMax 20;", "Papanastasiou;"})
    {
        Specimens two("muI; regularisation " + (law + Sand().entries()), 2);
        two.P.p[0] = 0;
        two.P.p[1] = 10;
        two.P.q[1] = -12;
        for (label i = 0; i < 2; ++i)
        {
            two.setStress(i, 3, 4);
            two.shear(i, 5);
        }
        two.correct(1e-3);
        for (label i = 0; i < 2; ++i)
        {
            EXPECT_EQ(two.P.s[i], tensor::Zero());
            EXPECT_EQ(two.P.eta[i], 0);
            EXPECT_EQ(two.P.I[i], 0);
        }
    }
}

TEST(muI, entriesAreChecked)
{
    const std::string sand = Sand().entries();
    EXPECT_THROW(Specimens("muI;" + sand), IOError);
    EXPECT_THROW(Specimens("muI; regularisation cap;" + sand), IOError);
    EXPECT_THROW
    (
        Specimens("muI; regularisation Bercovier; etaMax 2;" + sand), IOError
    );
    Sand wrong;
    wrong.mu2 = 0.1;
    EXPECT_THROW
    (
        Specimens("muI; regularisation cap; etaMax 2;" + wrong.entries()),
        IOError
    );
}

} // namespace sph
