// Speed of the recommended scheme: nanoseconds a particle of each part of a
// step, and whole steps on one and two threads. The last line is
//
//     particleSteps/s/core: X
//
// whole steps, double precision, one thread, 10^4 particles.

#include "benchmarks/CollapseScene.H"

#include <benchmark/benchmark.h>
#include <omp.h>

#include <fstream>
#include <iostream>
#include <map>

namespace sph
{

// Scenes in mid-collapse, made once for each number of particles
static CollapseScene& scene(const label nr)
{
    static std::map<label, std::unique_ptr<CollapseScene>> scenes;
    auto& s = scenes[nr];
    if (!s)
    {
        s = std::make_unique<CollapseScene>(nr);
        // 0.1 s: the fastest part of the collapse
        for (label step = 0; step < 22*nr; ++step)
        {
            s->step();
        }
    }
    return *s;
}

template<void (CollapseScene::*Part)()>
static void part(benchmark::State& state)
{
    omp_set_num_threads(1);
    CollapseScene& s = scene(label(state.range(0)));
    const scalar begin = omp_get_wtime();
    for (auto _ : state)
    {
        (s.*Part)();
    }
    state.counters["ns/particle"] =
        1e9*(omp_get_wtime() - begin)/state.iterations()/s.size();
}

static scalar particleSteps = 0;

static void wholeStep(benchmark::State& state)
{
    const label nr = label(state.range(0)), threads = label(state.range(1));
    CollapseScene& s = scene(nr);
    omp_set_num_threads(threads);
    const scalar begin = omp_get_wtime();
    for (auto _ : state)
    {
        s.step();
    }
    const scalar rate =
        scalar(state.iterations())*s.size()/(omp_get_wtime() - begin);
    state.counters["particles"] = s.size();
    state.counters["neighbours"] = s.neighboursPerParticle();
    state.counters["Mparticle-steps/s"] = 1e-6*rate;
    if (nr == 105 && threads == 1)
    {
        particleSteps = std::max(particleSteps, rate);
    }
}

BENCHMARK(part<&CollapseScene::move>)->Name("move")->Arg(105);
BENCHMARK(part<&CollapseScene::rebuildPairs>)->Name("rebuildPairs")->Arg(105);
BENCHMARK(part<&CollapseScene::wallVelocity>)->Name("wallVelocity")->Arg(105);
BENCHMARK(part<&CollapseScene::gradients>)->Name("gradients")->Arg(105);
BENCHMARK(part<&CollapseScene::pointwise>)->Name("pointwise")->Arg(105);
BENCHMARK(part<&CollapseScene::wallStress>)->Name("wallStress")->Arg(105);
BENCHMARK(part<&CollapseScene::forces>)->Name("forces")->Arg(105);

// Steps move the scene on: a fixed number of them, so that runs compare
BENCHMARK(wholeStep)->Name("wholeStep")->ArgNames({"nr", "threads"})
    ->Args({105, 1})->Args({105, 2})->Iterations(400)->Repetitions(3)
    ->UseRealTime()->Unit(benchmark::kMillisecond);

} // namespace sph

int main(int argc, char* argv[])
{
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
    {
        return 1;
    }
    // The log of the steps is part of their cost, but nobody wants to read it
    std::ofstream nowhere("/dev/null");
    std::ostream report(std::cout.rdbuf());
    std::cout.rdbuf(nowhere.rdbuf());
    benchmark::ConsoleReporter console(benchmark::ConsoleReporter::OO_Tabular);
    console.SetOutputStream(&report);
    console.SetErrorStream(&report);
    benchmark::RunSpecifiedBenchmarks(&console);
    report << "particleSteps/s/core: " << sph::particleSteps << std::endl;
    std::cout.rdbuf(report.rdbuf());
    return 0;
}
