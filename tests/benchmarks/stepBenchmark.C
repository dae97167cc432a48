#include "benchmarks/stepBenchmark.H"

#include "benchmarks/Samples.H"

#include <omp.h>

namespace sph
{

static constexpr label chunk = 25;

// Steps after which a scene returns to its start, to stay in mid-collapse
static constexpr label window = 16*chunk;

// Seconds for steps on more than one thread: beside other programs, barriers
// wait for whole time slices
static constexpr scalar patience = 10;

static void countParts
(
    benchmark::State& state, const StepClock& clock,
    const label rebuilds, const label size
)
{
    for (const Part part : StepClock::parts)
    {
        const label times =
            part == Part::rebuild ? rebuilds
          : part == Part::images ? chunk - rebuilds
          : chunk;
        if (times > 0)
        {
            state.counters[StepClock::name(part)] =
                1e9*clock.seconds(part)/times/size;
        }
    }
}

static void run
(
    benchmark::State& state, CollapseScene& scene, const label threads
)
{
    static scalar spent = 0;
    const bool skipped = threads > 1 && spent > patience;
    if (scene.steps() >= window)
    {
        scene.rewind();
    }
    const label before = scene.rebuilds();
    const scalar begin = omp_get_wtime();
    scene.clock().reset();
    omp_set_num_threads(threads);
    for (auto _ : state)
    {
        if (!skipped)
        {
            scene.step();
        }
    }
    omp_set_num_threads(1);
    if (skipped)
    {
        return;     // without counters: no sample
    }
    spent += threads > 1 ? omp_get_wtime() - begin : 0;

    const label rebuilds = scene.rebuilds() - before;
    countParts(state, scene.clock(), rebuilds, scene.size());
    state.counters["rebuilds"] = scalar(rebuilds)/chunk;
    state.counters["neighbours"] = scene.neighboursPerParticle();
    state.counters["particles"] = scene.size();
    state.counters["passes"] = scene.passes();
    state.counters[Samples::ns] = Samples::perParticle(scene.size());
}

void addStepBenchmark
(
    const std::string& name, const std::function<CollapseScene&()>& scene,
    const label threads, const label chunks
)
{
    auto* steps = benchmark::RegisterBenchmark
    (
        name.c_str(),
        [=](benchmark::State& state) { run(state, scene(), threads); }
    );
    steps->Iterations(chunk)->Repetitions(chunks);
    if (threads > 1)
    {
        steps->UseRealTime();
    }
}

} // namespace sph
