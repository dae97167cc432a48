// Whole steps: on one thread and on two, and from 10^4 to 10^6 particles.

#include "benchmarks/Table.H"
#include "benchmarks/scenes.H"
#include "benchmarks/stepBenchmark.H"
#include "benchmarks/themes.H"

#include <omp.h>

namespace sph
{

// k: every particle of the first one is split into k by k
static const struct { const char* name; label k, chunks; } sizes[] =
{
    {"step", 1, 100}, {"step/10^5", 3, 12}, {"step/10^6", 10, 6}
};

static const char* const twoThreads = "step/twoThreads";
static const char* const largeTwoThreads = "step/10^5/twoThreads";

void addWholeSteps(const bool large)
{
    for (const auto& [name, k, chunks] : sizes)
    {
        if (k < 10 || large)
        {
            addStepBenchmark
            (
                name,
                [k = k]() -> CollapseScene& { return midCollapse(k); },
                1, chunks
            );
        }
    }
    if (omp_get_num_procs() > 1)
    {
        addStepBenchmark
        (
            twoThreads,
            []() -> CollapseScene& { return midCollapse(); }, 2, 60
        );
        addStepBenchmark
        (
            largeTwoThreads,
            []() -> CollapseScene& { return midCollapse(3); }, 2, 12
        );
    }
}

static void printSpeed(const Samples& samples, std::ostream& os)
{
    Table table
    (
        os, "Whole steps: ns a particle, million particle-steps/s, time"
        " relative to the first line\n(two threads: elapsed time; otherwise"
        " processor time, here and below)"
    );
    table.heading
    (
        {"", "ns", "", "M/s", "", "relative", "relative", "neigh-", "steps a"}
    );
    table.heading
    (
        {
            "particles", "min", "median", "median", "best", "a step", "a pair",
            "bours", "rebuild"
        }
    );
    const scalar base = samples.median("step");
    const scalar pairs = samples.mean("step", "neighbours");
    for
    (
        const char* name :
        {"step", twoThreads, "step/10^5", largeTwoThreads, "step/10^6"}
    )
    {
        const scalar min = samples.min(name), median = samples.median(name);
        const scalar neighbours = samples.mean(name, "neighbours");
        table.row
        (
            name,
            {
                samples.mean(name, "particles"), min, median,
                1e3/median, 1e3/min, median/base,
                median/base*pairs/neighbours, neighbours,
                1/samples.mean(name, "rebuilds")
            }
        );
    }
}

// Which parts of a step cost more where there are more particles
static void printGrowth(const Samples& samples, std::ostream& os)
{
    Table table
    (
        os, "Parts of these steps, ns a particle, and memory that is allocated"
    );
    table.heading({"gradients", "forces", "rebuild", "others", "bytes"});
    for (const auto& [name, k, chunks] : sizes)
    {
        const scalar gradients = samples.median(name, "gradients");
        const scalar forces = samples.median(name, "forces");
        const scalar rebuild =
            samples.mean(name, "rebuilds")*samples.median(name, "rebuild");
        table.row
        (
            name,
            {
                gradients, forces, rebuild,
                samples.median(name) - gradients - forces - rebuild,
                bytesPerParticle(k)
            }
        );
    }
}

void printWholeSteps
(
    const Samples& samples, std::ostream& os, Figures& figures
)
{
    printSpeed(samples, os);
    printGrowth(samples, os);
    for (const char* name : {twoThreads, largeTwoThreads})
    {
        figures.emplace_back(name, samples.median(name));
    }
    for (const auto& [name, k, chunks] : sizes)
    {
        figures.emplace_back(name, samples.median(name));
        figures.emplace_back(std::string(name) + "/bytes", bytesPerParticle(k));
    }
}

} // namespace sph
