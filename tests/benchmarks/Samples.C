#include "benchmarks/Samples.H"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sph
{

benchmark::Counter Samples::perParticle(const label n)
{
    using benchmark::Counter;
    return Counter
    (
        1e-9*n, Counter::kIsIterationInvariantRate | Counter::kInvert
    );
}

void Samples::ReportRuns(const std::vector<Run>& runs)
{
    for (const Run& run : runs)
    {
        if (run.run_type == Run::RT_Iteration)
        {
            auto& counters = values_[run.run_name.function_name];
            for (const auto& [name, counter] : run.counters)
            {
                counters[name].push_back(counter.value);
            }
        }
    }
}

std::vector<scalar> Samples::sorted
(
    const std::string& name, const std::string& counter
) const
{
    std::vector<scalar> values;
    const auto counters = values_.find(name);
    if (counters != values_.end() && counters->second.count(counter))
    {
        values = counters->second.at(counter);
        std::sort(values.begin(), values.end());
    }
    return values;
}

scalar Samples::min(const std::string& name, const std::string& counter) const
{
    const auto values = sorted(name, counter);
    return values.empty() ? std::nan("") : values.front();
}

scalar Samples::median
(
    const std::string& name, const std::string& counter
) const
{
    const auto values = sorted(name, counter);
    return values.empty() ? std::nan("") : values[values.size()/2];
}

scalar Samples::mean(const std::string& name, const std::string& counter) const
{
    const auto values = sorted(name, counter);
    return std::accumulate(values.begin(), values.end(), 0.0)/values.size();
}

} // namespace sph
