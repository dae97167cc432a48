// Parts of a step. Within steps, a clock is read between them, so that they
// see the caches as they are in a run; alone, each is done over and over.

#include "benchmarks/Table.H"
#include "benchmarks/scenes.H"
#include "benchmarks/themes.H"

namespace sph
{

template<void (CollapseScene::*PartAlone)()>
static void addAlone(const Part part)
{
    benchmark::RegisterBenchmark
    (
        StepClock::name(part),
        [](benchmark::State& state)
        {
            CollapseScene& scene = pausedCollapse();
            (scene.*PartAlone)();   // warms the caches
            for (auto _ : state)
            {
                (scene.*PartAlone)();
            }
            state.counters[Samples::ns] = Samples::perParticle(scene.size());
        }
    )->Iterations(5)->Repetitions(100);
}

void addParts()
{
    addAlone<&CollapseScene::move>(Part::move);
    addAlone<&CollapseScene::rebuildPairs>(Part::rebuild);
    addAlone<&CollapseScene::wallVelocity>(Part::wallVelocity);
    addAlone<&CollapseScene::gradients>(Part::gradients);
    addAlone<&CollapseScene::pointwise>(Part::pointwise);
    addAlone<&CollapseScene::wallStress>(Part::wallStress);
    addAlone<&CollapseScene::forces>(Part::forces);
}

void printParts(const Samples& samples, std::ostream& os, Figures& figures)
{
    const scalar whole = samples.median("step");
    const scalar rebuilds = samples.mean("step", "rebuilds");
    const scalar nan = std::nan("");
    scalar sum = 0;

    Table table
    (
        os, "Parts of a step, ns a particle, one thread; images and rebuild:"
        " what falls to a step"
    );
    table.heading({"in steps", "", "", "alone", ""});
    table.heading({"min", "median", "share %", "min", "median"});
    for (const Part part : StepClock::parts)
    {
        const std::string name = StepClock::name(part);
        const scalar share =
            part == Part::rebuild ? rebuilds
          : part == Part::images ? 1 - rebuilds
          : 1;
        const scalar median = share*samples.median("step", name);
        table.row
        (
            name,
            {
                share*samples.min("step", name), median, 100*median/whole,
                share*samples.min(name), share*samples.median(name)
            }
        );
        figures.emplace_back(name, median);
        sum += median;
    }
    table.row("sum", {nan, sum, 100*sum/whole});
    table.row("whole step", {samples.min("step"), whole});
}

} // namespace sph
