// Speed of the recommended scheme: whole steps, the parts of a step, the walks
// over pairs against their limits, other models. The last line is
//
//     particleSteps/s/core: X
//
// whole steps, double precision, one thread, 10^4 particles: the median of
// many chunks of steps. Options beside those of Google Benchmark:
//
//     --large          10^6 particles as well: a minute and 1.5 GB more
//     --history FILE   CSV file that gets a line (build/benchmarks.csv)
//
// All benchmarks are cut into short repetitions, which Google Benchmark runs
// in random order: a machine whose speed drifts slows all of them alike.

#include "benchmarks/history.H"
#include "benchmarks/machine.H"
#include "pairs/pairLanes.H"
#include "primitives/error.H"

#include <omp.h>

#include <fstream>
#include <iomanip>
#include <iostream>

namespace sph
{

struct Options
{
    bool large = false;
    std::filesystem::path history =
        std::filesystem::path(SPH_BIN_DIR).parent_path()/"benchmarks.csv";
};

// The log of the steps is part of their cost, but nobody wants to read it
class Silence
{
    std::ofstream nowhere_{"/dev/null"};
    std::streambuf* const before_ = std::cout.rdbuf(nowhere_.rdbuf());

public:
    ~Silence() { std::cout.rdbuf(before_); }
};

static void printHelp()
{
    std::cout << "sphBenchmark [--large] [--history FILE]\n";
    benchmark::PrintDefaultHelp();
}

static Options readOptions(int argc, char* argv[])
{
    std::vector<char*> arguments(argv, argv + argc);
    char interleaved[] = "--benchmark_enable_random_interleaving=true";
    arguments.insert(arguments.begin() + 1, interleaved);
    int n = int(arguments.size());
    benchmark::Initialize(&n, arguments.data(), printHelp);

    Options options;
    for (int k = 1; k < n; ++k)
    {
        const std::string argument = arguments[k];
        if (argument == "--large")
        {
            options.large = true;
        }
        else if (argument == "--history" && k + 1 < n)
        {
            options.history = arguments[++k];
        }
        else
        {
            throw Error("Unknown option " + argument + "; see --help");
        }
    }
    return options;
}

// Returns whether all went well
static bool print
(
    const Samples& samples, std::ostream& os, const Options& options
)
{
    bool written = true;
    const scalar median = 1e9/samples.median("step");
    const scalar best = 1e9/samples.min("step");
    Figures figures{{"particleSteps/s", median}, {"best", best}};
    os << processor() << ", " << width<pairLanes> << " lanes, " << compiler()
        << ", commit " << version() << '\n';
    printWholeSteps(samples, os, figures);
    printParts(samples, os, figures);
    printLimits(samples, os, figures);
    printModels(samples, os, figures);
    if (benchmark::GetBenchmarkFilter().empty())
    {
        try
        {
            appendToHistory(options.history, figures);
            os << "\nHistory: " << options.history.string() << '\n';
        }
        catch (const Error& error)
        {
            os << "\nNo line in the history: " << error.what() << '\n';
            written = false;
        }
    }
    if (best > 0)
    {
        os << std::scientific << std::setprecision(3)
            << "\nparticleSteps/s/core best: " << best
            << "\nparticleSteps/s/core: " << median << std::endl;
    }
    return written;
}

static int run(int argc, char* argv[])
{
    const Options options = readOptions(argc, argv);
    addWholeSteps(options.large);
    addParts();
    addLimits();
    addModels();

    omp_set_num_threads(1);
    Samples samples;
    std::ostream os(std::cout.rdbuf());
    samples.SetOutputStream(&os);
    {
        const Silence silence;
        benchmark::RunSpecifiedBenchmarks(&samples);
    }
    return samples.empty() || print(samples, os, options) ? 0 : 1;
}

} // namespace sph

int main(int argc, char* argv[])
{
    return sph::runMain("sphBenchmark", [&]() { return sph::run(argc, argv); });
}
