#include "setup/setupOptions.H"

#include "runTime/TimeControls.H"
#include "runTime/log.H"

#include <cmath>
#include <cstdlib>

namespace sph
{

std::filesystem::path setupDictPath(const CommandLine& args)
{
    namespace fs = std::filesystem;
    const fs::path caseDir = args.caseDir();
    if (!args.found("dict"))
    {
        return caseDir/"system"/"setParticlesDict";
    }

    // An absolute path replaces what stands before it
    const fs::path given = args.value("dict");
    std::string places;
    for
    (
        const fs::path& path :
        {caseDir/given, caseDir/"system"/given, fs::absolute(given)}
    )
    {
        if (fs::is_regular_file(path))
        {
            return path;
        }
        places += "    " + path.string() + '\n';
    }
    throw Error
    (
        "There is no dictionary " + given.string() + "; looked for\n" + places
    );
}

Time::Instant setupTime
(
    const CommandLine& args, const dictionary& controlDict
)
{
    const TimeControls controls(controlDict);
    if (!args.found("time"))
    {
        return
        {
            controls.startTime,
            controls.timeName(controls.startTime, controls.timePrecision)
        };
    }
    const std::string name = args.value("time");
    char* end = nullptr;
    const scalar value = std::strtod(name.c_str(), &end);
    if (name.empty() || *end != '\0' || !std::isfinite(value))
    {
        throw Error("The option -time needs a time, not '" + name + "'");
    }
    return {value, name};
}

void warnOfLaterTimes
(
    const std::filesystem::path& caseDir, const Time::Instant& time
)
{
    std::string later;
    for (const Time::Instant& other : Time::findTimes(caseDir))
    {
        if (other.value > time.value)
        {
            later += ' ' + other.name;
        }
    }
    if (!later.empty())
    {
        warning
        (
            "Times of an earlier run are there:" + later
          + "\n    With startFrom latestTime the run goes on from the last of"
            " them, not from\n    these particles: remove them, or use"
            " startFrom startTime"
        );
    }
}

} // namespace sph
