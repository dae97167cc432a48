// The two walks over pairs against what was written by hand.

#include "benchmarks/HandWritten.H"
#include "benchmarks/Table.H"
#include "benchmarks/scenes.H"
#include "benchmarks/themes.H"

#include <algorithm>

namespace sph
{

static void compare
(
    const char* name, const scalarField& byLibrary, const scalarField& byHand,
    const label n
)
{
    scalar largest = 0, difference = 0;
    for (label i = 0; i < n; ++i)
    {
        largest = std::max(largest, std::abs(byLibrary[i]));
        difference = std::max(difference, std::abs(byLibrary[i] - byHand[i]));
    }
    const scalar tolerance = sizeof(pairScalar) == sizeof(scalar) ? 1e-9 : 1e-4;
    if (!(difference <= tolerance*largest))
    {
        std::ostringstream message;
        message << "The limits are not those of this scheme: " << name
            << " by hand differs by " << difference/largest
            << " of its largest value";
        throw Error(message.str());
    }
}

static void check(CollapseScene& scene, HandWritten& byHand)
{
    const Particles& P = scene.particles();
    const label n = scene.size();
    scene.gradients();
    byHand.packGradients();
    byHand.gradients();
    compare("L", P.L.xx, byHand.L.xx, n);
    compare("L", P.L.xy, byHand.L.xy, n);
    compare("L", P.L.yy, byHand.L.yy, n);
    compare("lambda", P.lambda, byHand.lambda, n);
    compare("w", P.w, byHand.w, n);
    compare("gradU", P.gradU.xx, byHand.gradU.xx, n);
    compare("gradU", P.gradU.xy, byHand.gradU.xy, n);
    compare("gradU", P.gradU.yx, byHand.gradU.yx, n);
    compare("gradU", P.gradU.yy, byHand.gradU.yy, n);
    compare("div", P.div, byHand.div, n);
    compare("gammaDot", P.gammaDot, byHand.gammaDot, n);
    compare("gradRho", P.gradRho.x, byHand.gradRho.x, n);
    compare("gradRho", P.gradRho.y, byHand.gradRho.y, n);
    compare("Us", P.Us.x, byHand.Us.x, n);
    compare("Us", P.Us.y, byHand.Us.y, n);

    scene.forces();
    byHand.packForces();
    byHand.forces();
    compare("a", P.a.x, byHand.a.x, n);
    compare("a", P.a.y, byHand.a.y, n);
    compare("rhoDot", P.rhoDot, byHand.rhoDot, n);
}

static HandWritten& handWritten()
{
    static std::unique_ptr<HandWritten> byHand;
    if (!byHand)
    {
        CollapseScene& scene = pausedCollapse();
        byHand = std::make_unique<HandWritten>
        (
            scene.particles(), scene.pairs(), scene.kernel(),
            scene.material(), scene.g()
        );
        check(scene, *byHand);
    }
    return *byHand;
}

// Lanes of the lists a particle, padding included
static scalar pairsPerParticle(CollapseScene& scene)
{
    scalar rows = 0;
    for (const PairList::Slice& slice : scene.pairs().slices())
    {
        rows += slice.n;
    }
    return rows*laneCount/scene.size();
}

template<class Body>
static void add
(
    const std::string& name, void (HandWritten::*pack)(), const Body body
)
{
    benchmark::RegisterBenchmark
    (
        name.c_str(),
        [=](benchmark::State& state)
        {
            CollapseScene& scene = pausedCollapse();
            HandWritten& byHand = handWritten();
            (byHand.*pack)();
            body(byHand);           // warms the caches
            for (auto _ : state)
            {
                body(byHand);
            }
            state.counters[Samples::ns] = Samples::perParticle(scene.size());
            state.counters["pairs"] = pairsPerParticle(scene);
        }
    )->Iterations(5)->Repetitions(100);
}

void addLimits()
{
    using H = HandWritten;
    add("gradients/pack", &H::packGradients, [](H& h) { h.packGradients(); });
    add("forces/pack", &H::packForces, [](H& h) { h.packForces(); });
    add("gradients/byHand", &H::packGradients, [](H& h) { h.gradients(); });
    add
    (
        "gradients/geometry", &H::packGradients,
        [](H& h) { benchmark::DoNotOptimize(h.geometryForGradients()); }
    );
    add
    (
        "gradients/fetch", &H::packGradients,
        [](H& h) { benchmark::DoNotOptimize(h.fetchForGradients()); }
    );
    add("forces/byHand", &H::packForces, [](H& h) { h.forces(); });
    add
    (
        "forces/geometry", &H::packForces,
        [](H& h) { benchmark::DoNotOptimize(h.geometryForForces()); }
    );
    add
    (
        "forces/fetch", &H::packForces,
        [](H& h) { benchmark::DoNotOptimize(h.fetchForForces()); }
    );
}

void printLimits(const Samples& samples, std::ostream& os, Figures& figures)
{
    Table table
    (
        os, "Walks over pairs and their limits, each alone, ns a particle, one"
        " thread\n(byHand: the same sums in one hand-written loop over packed"
        " records, the limit;\ngeometry: its loads, r, F and W; fetch: its"
        " loads only)"
    );
    table.heading({"", "", "ratio to", "byHand", "pairs a"});
    table.heading({"min", "median", "min", "median", "particle"});
    for (const std::string pass : {"gradients", "forces"})
    {
        const std::string limit = pass + "/byHand";
        const scalar min = samples.min(pass), median = samples.median(pass);
        const scalar ratio = median/samples.median(limit);
        table.row
        (
            pass,
            {
                min, median, min/samples.min(limit), ratio,
                samples.mean(limit, "pairs")
            }
        );
        for (const char* part : {"/pack", "/byHand", "/geometry", "/fetch"})
        {
            const std::string name = pass + part;
            table.row("  " + name, {samples.min(name), samples.median(name)});
        }
        figures.emplace_back(pass + "/alone", median);
        figures.emplace_back(limit, samples.median(limit));
        figures.emplace_back(pass + "/ratio", ratio);
    }
}

} // namespace sph
