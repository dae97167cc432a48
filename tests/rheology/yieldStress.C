#include "Specimens.H"

namespace sph
{

namespace
{

// Shear stress under simple shear
scalar shearStress(const std::string& law, const scalar rate)
{
    Specimens one(law);
    one.shear(0, rate);
    one.correct(1e-3);
    EXPECT_EQ(one.P.s.xx[0], 0);
    EXPECT_NEAR(one.P.s.xy[0], one.P.eta[0]*rate, 1e-12*one.P.s.xy[0]);
    return one.P.s.xy[0];
}

const char* const cap = "regularisation cap; etaMax 1e9;";

} // namespace

TEST(Bingham, stressIsYieldStressAndViscosity)
{
    for (const scalar rate : {1e-4, 0.3, 20.0, 4e3})
    {
        const scalar tau = 20 + 0.5*rate;
        EXPECT_NEAR
        (
            shearStress(std::string("Bingham; tau0 20; eta 0.5;") + cap, rate),
            tau, 1e-12*tau
        );
        EXPECT_NEAR
        (
            shearStress
            (
                "Bingham; tau0 20; eta 0.5;"
                " regularisation Papanastasiou; alphar 0.7;",
                rate
            ),
            20*(1 - std::exp(-rate/0.7)) + 0.5*rate, 1e-10*tau
        );
    }
}

TEST(HerschelBulkley, stressIsYieldStressAndAPowerOfTheRate)
{
    for (const char* n : {"0.4", "1", "1.8"})
    {
        const std::string law =
            std::string("HerschelBulkley; tau0 20; k 3; n ") + n + ';';
        for (const scalar rate : {1e-2, 0.3, 20.0, 4e3})
        {
            const scalar flow = 3*std::pow(rate, std::stod(n));
            EXPECT_NEAR(shearStress(law + cap, rate)/(20 + flow), 1, 1e-7);
            EXPECT_NEAR
            (
                shearStress
                (
                    law + "regularisation Papanastasiou; alphar 0.7;", rate
                )/(20*(1 - std::exp(-rate/0.7)) + flow),
                1, 1e-7
            );
        }
    }
}

TEST(HerschelBulkley, isFiniteAtRest)
{
    const std::string law = "HerschelBulkley; tau0 20; k 3; n 0.5; alphas 1;";
    Specimens capped(law + "regularisation cap; etaMax 50;");
    Specimens smooth(law + "regularisation Papanastasiou; alphar 0.5;");
    for (Specimens* one : {&capped, &smooth})
    {
        one->shear(0, 0);
        one->correct(1e-3);
        EXPECT_EQ(one->P.s[0], tensor::Zero());
    }
    EXPECT_EQ(capped.P.eta[0], 50);
    EXPECT_NEAR(smooth.P.eta[0], 20/0.5 + 3, 1e-12);
}

TEST(yieldStress, entriesAreChecked)
{
    EXPECT_THROW(Specimens("Bingham; tau0 20; eta 0.5;"), IOError);
    EXPECT_THROW
    (
        Specimens("Bingham; tau0 -1; eta 0.5; regularisation cap; etaMax 1;"),
        IOError
    );
    EXPECT_THROW
    (
        Specimens
        (
            "Bingham; tau0 1; eta 0.5; regularisation Papanastasiou;"
        ),
        IOError
    );
    EXPECT_THROW
    (
        Specimens
        (
            "HerschelBulkley; tau0 1; k -1; n 1; regularisation cap; etaMax 1;"
        ),
        IOError
    );
    EXPECT_THROW
    (
        Specimens("elastoViscoplasticHerschelBulkley; tau0 1; k 1; n 0;"),
        IOError
    );
}


// * * * With an elastic stress

// tau = tau0 + k ((tau* - tau)/(G dt))^n, by bisection
TEST(elastoViscoplasticHerschelBulkley, solvesTheFlowRuleOfTheStep)
{
    const scalar G = 5e4, tau0 = 20;
    for (const scalar k : {0.0, 1e-3, 2.0, 1e4})
    {
        for (const scalar n : {0.3, 0.6, 1.0, 1.7})
        {
            for (const scalar factor : {0.5, 1.0, 1.0001, 1.5, 30.0})
            {
                for (const scalar dt : {1e-7, 1e-5, 1e-2})
                {
                    std::ostringstream law;
                    law << "elastoViscoplasticHerschelBulkley; tau0 20; k "
                        << k << "; n " << n << ';';
                    Specimens one(law.str());
                    const scalar trial = factor*tau0;
                    one.setStress(0, 0.6*trial, -0.8*trial);
                    one.correct(dt);

                    scalar low = std::min(trial, tau0), high = trial;
                    for (label step = 0; step < 200; ++step)
                    {
                        const scalar tau = 0.5*(low + high);
                        const scalar flow =
                            k*std::pow((trial - tau)/(G*dt), n);
                        (tau < tau0 + flow ? low : high) = tau;
                    }
                    EXPECT_NEAR(one.tau()/high, 1, 1e-10)
                        << "k " << k << " n " << n << " tau*/tau0 " << factor
                        << " dt " << dt;
                    EXPECT_NEAR(one.P.s.xx[0], 0.6*one.tau(), 1e-12*trial);
                }
            }
        }
    }
}

TEST(elastoViscoplasticHerschelBulkley, steadyShearHasTheStressOfTheLaw)
{
    for (const scalar n : {0.5, 1.0, 1.5})
    {
        for (const scalar rate : {0.1, 3.0, 50.0})
        {
            std::ostringstream law;
            law << "elastoViscoplasticHerschelBulkley; tau0 20; k 4; n " << n
                << ';';
            // Little elastic strain, so that it does not turn the stress
            Specimens one(law.str(), 1, 1e7);
            one.shear(0, rate);
            for (label k = 0; k < 5000; ++k)
            {
                one.correct(0.1/rate/5000);
            }
            const scalar tau = 20 + 4*std::pow(rate, n);
            EXPECT_NEAR(one.P.s.xy[0]/tau, 1, 1e-4) << n << ' ' << rate;
        }
    }
}

// It needs no pressure, and keeps its stress without a rate
TEST(elastoViscoplasticHerschelBulkley, isElasticBelowYield)
{
    Specimens one("elastoViscoplasticHerschelBulkley; tau0 20; k 4;");
    one.pureShear(0, 2);
    for (label k = 1; k <= 10; ++k)
    {
        one.correct(1e-5);
        EXPECT_NEAR(one.P.s.xy[0], 5e4*2*1e-5*k, 1e-10);
    }
    one.pureShear(0, 0);
    one.correct(1);
    EXPECT_NEAR(one.tau(), 10, 1e-10);
    EXPECT_TRUE(one.rheology->elastic());
    EXPECT_NEAR(one.rheology->G(), 5e4, 1e-9);
}

} // namespace sph
