#include "estimate.H"

#include <chrono>
#include <cmath>
#include <iostream>
#include <sys/resource.h>

using namespace sph;

namespace
{

constexpr label nSteps = 10;

// The most that the process has held so far [MB]
scalar peakMemory()
{
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss/1024.0;
}

} // namespace


void printEstimate
(
    const Time& runTime,
    const Particles& particles,
    const TimeStep& timeStep,
    const std::function<void(scalar time, scalar dt)>& step
)
{
    using Clock = std::chrono::steady_clock;

    const scalar left = runTime.endTime() - runTime.value();
    std::cout << "\n// * * * Estimate\n\n";
    if (!runTime.run())
    {
        std::cout << "Nothing to do: endTime is reached\n";
        return;
    }

    scalar time = runTime.value();
    scalar dt = 0;
    const auto advance = [&]
    {
        dt = runTime.grownDeltaT(timeStep.stable(particles));
        time += dt;
        step(time, dt);
    };
    advance();      // makes the lists
    const auto begin = Clock::now();
    for (label i = 0; i < nSteps; ++i)
    {
        advance();
    }
    const scalar perStep =
        std::chrono::duration<scalar>(Clock::now() - begin).count()/nSteps;

    const label n = particles.granular().size();
    std::cout
        << "Particles: " << n << " granular and "
        << particles.walls().size() << " wall\n"
        << "Rate: " << n/perStep << " particle-steps/s, measured over "
        << nSteps << " steps in memory\n"
        << "Memory: " << peakMemory() << " MB, measured\n"
        << "deltaT: " << dt << " s\n";
    if (std::isfinite(left))
    {
        const scalar steps = std::ceil(left/dt);
        std::cout
            << "Steps to endTime: " << steps << " of that size\n"
            << "Time: " << steps*perStep << " s, without output and function"
               " objects\n";
    }
    else
    {
        std::cout << "Steps to endTime: none is given\n";
    }
}
