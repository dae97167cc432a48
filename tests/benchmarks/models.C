// A model that is not selected costs nothing; one that shares no loop with the
// others costs a pass of its own.

#include "benchmarks/Table.H"
#include "benchmarks/scenes.H"
#include "benchmarks/stepBenchmark.H"
#include "benchmarks/themes.H"

namespace sph
{

static const std::vector<std::pair<std::string, CollapseScene::Changes>>&
models()
{
    static const std::string noShifting = "shifting none;";
    static const std::string noStabilisation = "stabilisation none;";
    static const std::string noViscosity = "artificialViscosity none;";
    static const std::string muI =
        "rheology muI;"
        "muICoeffs"
        "{"
        "    mus 0.589; mu2 1.248; I0 0.279; d 3.2e-4; rhos 2600;"
        "    regularisation cap; etaMax 2;"
        "}";
    static const std::vector<std::pair<std::string, CollapseScene::Changes>>
    models
    {
        {"recommended", {}},
        {"no shifting", {"", noShifting}},
        {"no stabilisation", {"", noStabilisation}},
        {"no artificialViscosity", {"", noViscosity}},
        {"none of the three", {"", noShifting + noStabilisation + noViscosity}},
        {"muI, stressDivergence", {muI, ""}},
        {"muI, Morris", {muI, "viscousScheme Morris;"}},
        {"WendlandC2", {"", "kernel WendlandC2;"}}
    };
    return models;
}

void addModels()
{
    for (const auto& [name, changes] : models())
    {
        addStepBenchmark
        (
            name,
            [name = name, changes = changes]() -> CollapseScene&
            {
                return midCollapse(name, changes);
            },
            1, 32
        );
    }
}

void printModels(const Samples& samples, std::ostream& os, Figures& figures)
{
    const std::string recommended = models().front().first;
    Table table
    (
        os, "Whole steps with other models, ns a particle, one thread"
    );
    table.heading({"min", "median", "saved", "gradients", "forces", "passes"});
    for (const auto& [name, changes] : models())
    {
        const scalar median = samples.median(name);
        table.row
        (
            name,
            {
                samples.min(name), median, samples.median(recommended) - median,
                samples.median(name, "gradients"),
                samples.median(name, "forces"), samples.mean(name, "passes")
            }
        );
        figures.emplace_back(name, median);
    }
}

} // namespace sph
