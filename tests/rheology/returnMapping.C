#include "Specimens.H"
#include "support/Threads.H"

namespace sph
{

// d tau/dt = G (rate - plastic rate), the plastic rate that at which
// mu(I) P = tau; Runge-Kutta of fourth order
static scalar integrated
(
    const Sand& sand, scalar tau, const scalar rate, const scalar P,
    const scalar T, const label steps
)
{
    const auto slope = [&](const scalar t)
    {
        const scalar S0 = sand.mus*P, S2 = sand.mu2*P;
        const scalar I = t <= S0 ? 0 : sand.I0*(t - S0)/(S2 - t);
        return sand.G*(rate - I*std::sqrt(P/sand.rhos)/sand.d);
    };
    const scalar dt = T/steps;
    for (label k = 0; k < steps; ++k)
    {
        const scalar k1 = slope(tau);
        const scalar k2 = slope(tau + 0.5*dt*k1);
        const scalar k3 = slope(tau + 0.5*dt*k2);
        const scalar k4 = slope(tau + dt*k3);
        tau += dt/6*(k1 + 2*k2 + 2*k3 + k4);
    }
    return tau;
}

// One step solves tau = mu(I) P with I of (tau* - tau)/(G dt): by bisection
TEST(returnMapping, solvesTheFlowRuleOfTheStepExactly)
{
    const Sand sand;
    label plastic = 0;
    for (const scalar P : {1e-3, 0.7, 30.0, 1e3, 2e4})
    {
        for (const scalar factor : {0.2, 0.999, 1.001, 1.3, 3.0, 50.0, 1e4})
        {
            for (const scalar dt : {1e-8, 1e-6, 1e-5, 1e-3, 0.1})
            {
                const scalar trial = factor*sand.mus*P;
                Specimens one = muISpecimens(sand);
                one.P.p[0] = P;
                one.setStress(0, 0.6*trial, -0.8*trial);
                one.correct(dt);

                scalar low = 0, high = trial;
                if (trial > sand.mus*P)
                {
                    for (label k = 0; k < 200; ++k)
                    {
                        const scalar tau = 0.5*(low + high);
                        const scalar I = sand.inertialNumber
                        (
                            (trial - tau)/(sand.G*dt), P
                        );
                        (tau < sand.mu(I)*P ? low : high) = tau;
                    }
                    ++plastic;
                }
                EXPECT_NEAR(one.tau()/high, 1, 1e-10)
                    << "P " << P << " tau*/S0 " << factor << " dt " << dt;
                // along the trial stress
                EXPECT_NEAR(one.P.s.xx[0], 0.6*one.tau(), 1e-12*trial);
                EXPECT_NEAR(one.P.s.xy[0], -0.8*one.tau(), 1e-12*trial);
                EXPECT_EQ(one.P.s.yy[0], -one.P.s.xx[0]);
            }
        }
    }
    EXPECT_GT(plastic, 100);
}

// 100 000 and 200 000 steps, extrapolated, against the flow rule in time:
// relaxing from a stress and loaded at a rate
TEST(returnMapping, followsTheFlowRuleInTime)
{
    const Threads one(1);
    const Sand sand;
    struct Load
    {
        scalar P, tau0ByS0, rate;
    };
    const std::vector<Load> loads =
    {
        {1000, 0, 100}, {1000, 1.5, 0}, {1000, 1.6, 5}, {50, 0, 10},
        {50, 1.4, 0}, {5000, 1.2, 100}, {5000, 1.65, 0}, {300, 0.9, 300}
    };
    const scalar T = 1e-4;
    const label n = label(loads.size()), steps = 100000;
    std::vector<scalar> tau[2];
    for (label half = 0; half < 2; ++half)
    {
        Specimens all = muISpecimens(sand, n);
        for (label i = 0; i < n; ++i)
        {
            all.P.p[i] = loads[i].P;
            all.setStress(i, 0, loads[i].tau0ByS0*sand.mus*loads[i].P);
            all.pureShear(i, loads[i].rate);
        }
        const label total = half == 0 ? steps : 2*steps;
        for (label k = 0; k < total; ++k)
        {
            all.correct(T/total);
        }
        for (label i = 0; i < n; ++i)
        {
            tau[half].push_back(all.tau(i));
        }
    }
    label plastic = 0;
    for (label i = 0; i < n; ++i)
    {
        const auto& [P, tau0ByS0, rate] = loads[i];
        const scalar exact =
            integrated(sand, tau0ByS0*sand.mus*P, rate, P, T, steps);
        plastic += exact > 1.001*sand.mus*P;
        EXPECT_NEAR(tau[0][i]/exact, 1, 1e-4) << i;
        EXPECT_NEAR((2*tau[1][i] - tau[0][i])/exact, 1, 1e-6) << i;
    }
    EXPECT_GE(plastic, 5);
}

} // namespace sph
