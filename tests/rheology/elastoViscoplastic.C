#include "Specimens.H"

namespace sph
{

TEST(elastoViscoplastic, isElasticBelowYield)
{
    const Sand sand;
    Specimens one = muISpecimens(sand);
    one.P.p[0] = 1000;
    one.pureShear(0, 2);
    const scalar dt = 1e-5;
    label k = 0;
    for (; sand.G*2*dt*(k + 1) < sand.mus*1000; ++k)
    {
        one.correct(dt);
        EXPECT_NEAR(one.P.s.xy[0], sand.G*2*dt*(k + 1), 1e-9*sand.mus*1000);
        EXPECT_EQ(one.P.I[0], 0);
    }
    EXPECT_GT(k, 300);
    one.correct(dt);
    one.correct(dt);
    EXPECT_GT(one.P.I[0], 0);
    EXPECT_TRUE(one.rheology->elastic());
    EXPECT_NEAR(one.rheology->G(), sand.G, 1e-9);
}

TEST(elastoViscoplastic, neverExceedsMu2AndReachesItWithTheRate)
{
    const Sand sand;
    scalar before = 0;
    for (scalar rate = 1e-3; rate < 1e12; rate *= 10)
    {
        Specimens one = muISpecimens(sand);
        one.P.p[0] = 500;
        one.pureShear(0, rate);
        for (label k = 0; k < 50; ++k)
        {
            one.correct(1e-3);
            EXPECT_LE(one.tau(), sand.mu2*500*(1 + 1e-12)) << rate;
        }
        EXPECT_GE(one.tau(), before*(1 - 1e-12)) << "grows with the rate";
        before = one.tau();
    }
    EXPECT_NEAR(before, sand.mu2*500, 1e-4*500);
}

TEST(elastoViscoplastic, bearsNoStressWithoutPressure)
{
    const Sand sand;
    const scalar p[] = {0, 0, 100, 100, -5}, q[] = {0, -1, -100, -99, 2};
    Specimens some = muISpecimens(sand, 5);
    for (label i = 0; i < 5; ++i)
    {
        some.P.p[i] = p[i];
        some.P.q[i] = q[i];
        some.setStress(i, 30, -40);
        some.pureShear(i, 10);
    }
    some.correct(1e-4);
    for (const label i : {0, 1, 2, 4})
    {
        EXPECT_EQ(some.P.s[i], tensor::Zero()) << i;
        EXPECT_EQ(some.P.eta[i], 0);
        EXPECT_EQ(some.P.I[i], 0);
    }
    // P = p + q is what yields
    EXPECT_GT(some.tau(3), sand.mus*1);
    EXPECT_LT(some.tau(3), sand.mu2*1);
}

// s turns with the body: its components by twice the angle
TEST(elastoViscoplastic, rigidRotationTurnsTheStress)
{
    const Sand sand;
    const scalar omega = 3, s0 = 200, T = 0.25*pi/omega;
    Specimens one = muISpecimens(sand);
    one.P.p[0] = 1000;
    one.setStress(0, s0, 0);
    one.deform(0, (tensor() << 0, -omega, omega, 0).finished());
    const label steps = 20000;
    for (label k = 0; k < steps; ++k)
    {
        one.correct(T/steps);
    }
    // a quarter of a right angle twice: all of sxx has become sxy
    EXPECT_NEAR(one.P.s.xx[0], 0, 1e-6*s0);
    EXPECT_NEAR(one.P.s.xy[0], s0, 1e-6*s0);
    EXPECT_NEAR(one.tau(), s0, 1e-10*s0);
}

TEST(elastoViscoplastic, aLargeRotationKeepsTheNorm)
{
    const Sand sand;
    Specimens one = muISpecimens(sand);
    one.P.p[0] = 1000;
    one.setStress(0, 120, -160);
    one.deform(0, (tensor() << 0, -700, 700, 0).finished());
    one.correct(1e-3);
    EXPECT_NEAR(one.tau(), 200, 1e-11);
    EXPECT_GT(std::abs(one.P.s.xx[0] - 120), 10);
}

// K large: the elastic strain, tau/G, does not turn the stress noticeably
TEST(elastoViscoplastic, steadyShearHasFrictionMuOfI)
{
    const Sand sand;
    const scalar P = 1000;
    for (const scalar rate : {0.1, 1.0, 20.0, 300.0})
    {
        Specimens one = muISpecimens(sand, 1, 1e7);
        one.P.p[0] = P;
        one.shear(0, rate);
        for (label k = 0; k < 20000; ++k)
        {
            one.correct(0.1/rate/20000);
        }
        const scalar I = sand.inertialNumber(rate, P);
        EXPECT_NEAR(one.P.s.xy[0]/(sand.mu(I)*P), 1, 1e-5) << rate;
        EXPECT_NEAR(one.P.I[0]/I, 1, 1e-5);
        EXPECT_NEAR(one.P.eta[0]*rate/one.tau(), 1, 1e-12);
    }
}

TEST(elastoViscoplastic, volumeChangeGivesNoDeviatoricStress)
{
    const Sand sand;
    Specimens one = muISpecimens(sand);
    one.P.p[0] = 1000;
    one.deform(0, (tensor() << -3, 0, 0, -3).finished());
    one.correct(1e-3);
    EXPECT_EQ(one.P.s[0], tensor::Zero());
}

TEST(DruckerPrager, isTheLimitOfMuIForALargeI0)
{
    const Sand sand;
    Sand slow = sand, flat = sand;
    slow.I0 = 1e14;
    flat.mu2 = flat.mus;
    std::ostringstream entries;
    entries << "DruckerPrager; mus " << sand.mus << "; d 5e-4; rhos 2500;";
    for (const scalar rate : {1.0, 40.0, 2000.0})
    {
        Specimens rigid(entries.str());
        Specimens limit = muISpecimens(slow), same = muISpecimens(flat);
        for (Specimens* one : {&rigid, &limit, &same})
        {
            one->P.p[0] = 800;
            one->shear(0, rate);
            for (label k = 0; k < 200; ++k)
            {
                one->correct(1e-4);
            }
        }
        EXPECT_NEAR(rigid.tau()/std::min(rate*1e3, sand.mus*800), 1, 0.01);
        EXPECT_LE(rigid.tau(), sand.mus*800*(1 + 1e-12));
        EXPECT_LT((limit.P.s[0] - rigid.P.s[0]).norm(), 1e-8*rigid.tau());
        EXPECT_LT((same.P.s[0] - rigid.P.s[0]).norm(), 1e-8*rigid.tau());
    }
}

TEST(elastoViscoplastic, entriesAreChecked)
{
    Sand wrong;
    wrong.mu2 = 0.3;
    EXPECT_THROW(muISpecimens(wrong), IOError);
    wrong = Sand();
    wrong.d = 0;
    EXPECT_THROW(muISpecimens(wrong), IOError);
    EXPECT_THROW(Specimens("DruckerPrager; d 1e-3; rhos 2500;"), IOError);
}

TEST(elastoViscoplastic, shearModulusIsAShareOfTheBulkModulus)
{
    const Specimens one
    (
        "elastoViscoplasticMuI; GByK 0.3;" + Sand().entries(), 1, 2e5
    );
    EXPECT_NEAR(one.rheology->G(), 6e4, 1e-8);
}

} // namespace sph
