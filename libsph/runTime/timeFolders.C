// The time folders of a case on disk.
#include "runTime/Time.H"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace sph
{

namespace
{

// Whether the whole of a name is a decimal number: "0.05", not "0.orig"
bool isTimeName(const std::string& name, scalar& value)
{
    if (name.find_first_not_of("0123456789+-.eE") != std::string::npos)
    {
        return false;
    }
    char* end = nullptr;
    value = std::strtod(name.c_str(), &end);
    return end != name.c_str() && *end == '\0' && std::isfinite(value);
}

} // namespace


std::vector<Time::Instant> Time::findTimes
(
    const std::filesystem::path& caseDir
)
{
    std::vector<Instant> times;
    std::error_code error;
    for
    (
        std::filesystem::directory_iterator iter(caseDir, error), end;
        !error && iter != end;
        iter.increment(error)
    )
    {
        const std::string name = iter->path().filename().string();
        scalar value = 0;
        std::error_code ignored;
        if (isTimeName(name, value) && iter->is_directory(ignored))
        {
            times.push_back({value, name});
        }
    }
    std::sort
    (
        times.begin(), times.end(),
        [](const Instant& a, const Instant& b)
        {
            return a.value != b.value ? a.value < b.value : a.name < b.name;
        }
    );
    return times;
}

} // namespace sph
