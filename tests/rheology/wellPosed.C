#include "Specimens.H"
#include "rheology/WellPosedFriction.H"
#include "rheology/muIFriction.H"

namespace sph
{

namespace
{

struct Law
{
    const char* name;
    scalar mus, mu2, I0;
    scalar I1, I2;      // C = 0 of mu(I): roots found by others

    dictionary dict(const std::string& more = "") const
    {
        std::ostringstream os;
        os.precision(17);
        os << "mus " << mus << "; mu2 " << mu2 << "; I0 " << I0 << ';' << more;
        return dictionary::fromString(os.str(), "law");
    }

    WellPosedFriction make(const std::string& more = "") const
    {
        return WellPosedFriction(dict(more));
    }
};

// Roots of C computed apart from this code, five digits
const Law laws[] =
{
    {"glass beads", 0.38186, 0.64347, 0.279, 0.01935, 0.85227},
    {"discs of Lagree et al.", 0.32, 0.6, 0.4, 0.01363, 1.81011},
    {"example of Barker & Gray", 0.342, 0.557, 0.069, 0.00397, 0.28017},
    {"sand", 0.50953, 0.94565, 1.14, 0.14513, 1.44511},
    {"sand of the paper", 0.58905, 1.2482, 2.65, 0.43154, 1.81541},
    {"the same, I0 of glass", 0.58905, 1.2482, 0.279, 0.04543, 0.19113}
};

} // namespace

TEST(wellPosedness, boundsOfMuIAreThoseKnown)
{
    for (const Law& law : laws)
    {
        const muIFriction muI(law.dict());
        const auto C = [&](const scalar I) { return muI(I).C(); };
        EXPECT_GT(C(0.999*law.I1), 0) << law.name;
        EXPECT_LT(C(1.001*law.I1), 0) << law.name;
        EXPECT_LT(C(0.9999*law.I2), 0) << law.name;
        EXPECT_GT(C(1.0001*law.I2), 0) << law.name;
        EXPECT_GT(C(0), 0) << "at rest";
    }
}

TEST(wellPosedness, slopeIsTheDerivative)
{
    for (const Law& law : laws)
    {
        const WellPosedFriction wellPosed = law.make();
        const muIFriction muI(law.dict());
        for (const scalar I : {1e-9, 1e-4, 3e-3, 0.05, 0.7, 5.0})
        {
            const scalar e = 1e-5;
            EXPECT_NEAR
            (
                wellPosed.friction(I).n,
                std::log(wellPosed.mu(I*(1 + e))/wellPosed.mu(I*(1 - e)))/(2*e),
                1e-6
            );
            EXPECT_NEAR
            (
                muI(I).n,
                std::log(muI(I*(1 + e)).mu/muI(I*(1 - e)).mu)/(2*e), 1e-6
            );
        }
    }
}

// C <= 0 from rest up to where mu(I) is ill-posed again
TEST(wellPosedFriction, isWellPosedDownToRest)
{
    for (const Law& law : laws)
    {
        const WellPosedFriction wellPosed = law.make("muInf 0;");
        EXPECT_NEAR(wellPosed.I1()/law.I1, 1, 1e-3) << law.name;
        scalar largest = -1;
        for (scalar I = 1e-30; I < 0.9999*law.I2; I *= 1.01)
        {
            largest = std::max(largest, wellPosed.friction(I).C());
        }
        EXPECT_LE(largest, 1e-9) << law.name;
    }
}

// muInf moves the upper end from 0.28 to 17.0 for the paper's example
TEST(wellPosedFriction, muInfMovesTheUpperEnd)
{
    const WellPosedFriction wellPosed = laws[2].make("muInf 0.05;");
    for (scalar I = 1e-30; I < 16.9; I *= 1.01)
    {
        EXPECT_LE(wellPosed.friction(I).C(), 1e-9) << I;
    }
    EXPECT_GT(wellPosed.friction(17.1).C(), 0);
}

TEST(wellPosedFriction, isMuIInTheMiddleAndContinuous)
{
    for (const Law& law : laws)
    {
        const WellPosedFriction wellPosed = law.make("muInf 0;");
        const scalar I1 = wellPosed.I1();
        for (const scalar I : {1.0001*I1, 2*I1, 0.3, 4.0})
        {
            if (I > I1)
            {
                EXPECT_NEAR
                (
                    wellPosed.mu(I),
                    law.mus + (law.mu2 - law.mus)/(1 + law.I0/I), 1e-14
                );
            }
        }
        EXPECT_NEAR
        (
            wellPosed.mu(I1*(1 - 1e-12)), wellPosed.mu(I1*(1 + 1e-12)), 1e-11
        );
        EXPECT_NEAR
        (
            wellPosed.A()/I1,
            std::exp(1.9/std::pow(wellPosed.mu(I1), 2)), 1e-9*wellPosed.A()/I1
        );
    }
}

TEST(wellPosedFriction, hasNoYieldStress)
{
    const WellPosedFriction wellPosed = laws[0].make();
    EXPECT_EQ(wellPosed.mu(0), 0);
    scalar before = 0;
    for (scalar I = 1e-300; I < 100; I *= 10)
    {
        EXPECT_GT(wellPosed.mu(I), before);
        before = wellPosed.mu(I);
    }
    // A slope of 5 degrees flows, if slowly: tan(5) = 0.0875
    EXPECT_LT(wellPosed.mu(1e-110), 0.0875);
    EXPECT_GT(wellPosed.mu(1e-100), 0.0875);
}

TEST(wellPosedFriction, isRefusedWhereMuIIsIllPosedEverywhere)
{
    EXPECT_THROW((Law{"flat", 0.6, 0.6, 0.3, 0, 0}.make()), IOError);
    EXPECT_THROW(laws[0].make("alpha 2.1;"), IOError);
    EXPECT_THROW((Law{"", 0.6, 0.5, 0.3, 0, 0}.make()), IOError);
}

// a I + P mu(I) = tau, by bisection in ln I
TEST(wellPosedFriction, isSolvedForReturnMapping)
{
    label below = 0, above = 0;
    for (const Law& law : laws)
    {
        const WellPosedFriction wellPosed = law.make();
        for (const scalar P : {1e-2, 1.0, 3e3})
        {
            for (const scalar aByP : {1e-6, 1e-2, 1.0, 1e3, 1e7})
            {
                for (const scalar tauByP : {0.1, 0.3, 0.5, 0.7, 3.0, 1e4})
                {
                    scalar low = -700, high = 30;
                    for (label step = 0; step < 200; ++step)
                    {
                        const scalar I = std::exp(0.5*(low + high));
                        const scalar tau = aByP*I + wellPosed.mu(I);
                        (tau < tauByP ? low : high) = std::log(I);
                    }
                    const scalar I = std::exp(high);
                    (I < wellPosed.I1() ? below : above) += 1;
                    EXPECT_NEAR
                    (
                        wellPosed.solve(aByP*P, P, tauByP*P)/wellPosed.mu(I),
                        1, 1e-9
                    )   << law.name << " a/P " << aByP << " tau/P " << tauByP;
                }
            }
        }
    }
    EXPECT_GT(below, 100);
    EXPECT_GT(above, 100);
}


// * * * Materials

TEST(wellPosedMuI, shearStressIsMuP)
{
    const Sand sand;
    const WellPosedFriction law
    (
        dictionary::fromString(sand.entries(), "law")
    );
    const scalar P = 400;
    for (const scalar rate : {0.0, 1e-4, 0.02, 3.0, 300.0})
    {
        Specimens one("wellPosedMuI; etaMax 1e4;" + sand.entries(), 2);
        one.P.p[0] = P;
        one.P.p[1] = 0;
        one.shear(0, rate);
        one.shear(1, rate);
        one.correct(1e-3);
        const scalar I = sand.inertialNumber(rate, P);
        const scalar tau = std::min(law.mu(I)*P, 1e4*rate);
        EXPECT_NEAR(one.P.s.xy[0], tau, 1e-12*P) << rate;
        EXPECT_LE(one.P.eta[0], 1e4);
        EXPECT_NEAR(one.P.I[0], I, 1e-14);
        EXPECT_EQ(one.P.s[1], tensor::Zero());
    }
}

// K large: the elastic strain does not turn the stress noticeably
TEST(elastoViscoplasticWellPosedMuI, steadyShearHasFrictionMuOfI)
{
    const Sand sand;
    const WellPosedFriction law
    (
        dictionary::fromString(sand.entries(), "law")
    );
    const scalar P = 1000;
    for (const scalar rate : {1e-3, 0.1, 1.0, 20.0, 300.0})
    {
        Specimens one
        (
            "elastoViscoplasticWellPosedMuI;" + sand.entries(), 1, 1e7
        );
        one.P.p[0] = P;
        one.shear(0, rate);
        for (label k = 0; k < 20000; ++k)
        {
            one.correct(0.1/rate/20000);
        }
        const scalar I = sand.inertialNumber(rate, P);
        EXPECT_NEAR(one.P.s.xy[0]/(law.mu(I)*P), 1, 1e-4) << rate;
        EXPECT_NEAR(one.P.I[0]/I, 1, 1e-3) << rate;
    }
}

TEST(elastoViscoplasticWellPosedMuI, creepsWhereMuIStops)
{
    const Sand sand;
    const scalar P = 1000, start = 0.9*sand.mus*P;
    for (const char* law : {"", "WellPosed"})
    {
        Specimens one
        (
            std::string("elastoViscoplastic") + law + "MuI;" + sand.entries()
        );
        one.P.p[0] = P;
        one.setStress(0, 0, start);
        one.shear(0, 0);
        for (label k = 0; k < 1000; ++k)
        {
            one.correct(1e-3);
        }
        if (law[0] == '\0')
        {
            EXPECT_NEAR(one.tau(), start, 1e-9*start);
        }
        else
        {
            EXPECT_LT(one.tau(), 0.9*start);
            EXPECT_GT(one.tau(), 0.3*start);
        }
    }
}

TEST(friction, isKnownOfFrictionalLawsOnly)
{
    const Sand sand;
    EXPECT_EQ(Specimens("Newtonian; eta 1;").rheology->friction(0.1), std::nullopt);
    const auto muI = muISpecimens(sand).rheology->friction(0.1);
    ASSERT_TRUE(muI);
    EXPECT_NEAR(muI->mu, sand.mu(0.1), 1e-14);
    const auto constant =
        Specimens("DruckerPrager; mus 0.4; d 1e-3; rhos 2500;")
       .rheology->friction(0.1);
    ASSERT_TRUE(constant);
    EXPECT_GT(constant->C(), 0) << "ill-posed at any rate";
}

} // namespace sph
