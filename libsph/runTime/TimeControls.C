#include "runTime/TimeControls.H"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace sph
{

namespace
{

// A choice of dict as the enumerator with the same position in names
template<class Enum>
Enum choice
(
    const dictionary& dict, const word& key,
    const word& defaultName, const wordList& names
)
{
    const word name = dict.getChoiceOrDefault(key, defaultName, names);
    for (std::size_t i = 0; i < names.size(); ++i)
    {
        if (names[i] == name)
        {
            return static_cast<Enum>(i);
        }
    }
    dict.fail(key, "Unknown " + key + ' ' + name);
}

label boundedLabel
(
    const dictionary& dict, const word& key,
    const label defaultValue, const label min, const label max
)
{
    const label value = dict.getOrDefault<label>(key, defaultValue);
    if (value < min || value > max)
    {
        dict.fail
        (
            key,
            key + ' ' + std::to_string(value) + " must be "
          + (
                max == std::numeric_limits<label>::max()
              ? "at least " + std::to_string(min)
              : "from " + std::to_string(min) + " to " + std::to_string(max)
            )
        );
    }
    return value;
}

} // namespace


TimeControls::TimeControls(const dictionary& dict)
{
    readStartAndStop(dict);
    readStep(dict);
    readWriting(dict);
    readFormats(dict);

    runTimeModifiable = dict.getOrDefault<bool>("runTimeModifiable", true);

    // For the run scripts
    if (dict.found("application"))
    {
        dict.markUsed("application");
    }
}

void TimeControls::readStartAndStop(const dictionary& dict)
{
    startFrom = choice<StartFrom>
    (
        dict, "startFrom", "latestTime",
        {"firstTime", "startTime", "latestTime"}
    );
    startTime =
        startFrom == StartFrom::startTime
      ? dict.get("startTime", dimTime)
      : dict.getOrDefault("startTime", 0, dimTime);

    stopAt = choice<StopAt>
    (
        dict, "stopAt", "endTime",
        {"endTime", "writeNow", "noWriteNow", "nextWrite"}
    );
    endTime =
        stopAt == StopAt::endTime
      ? dict.get("endTime", dimTime)
      : dict.getOrDefault
        (
            "endTime", std::numeric_limits<scalar>::infinity(), dimTime
        );
}

void TimeControls::readStep(const dictionary& dict)
{
    const scalar inf = std::numeric_limits<scalar>::infinity();

    adjustTimeStep = dict.getOrDefault<bool>("adjustTimeStep", false);
    deltaT =
        adjustTimeStep && !dict.found("deltaT")
      ? 0
      : dict.get("deltaT", dimTime, Range::positive());
    maxCo = dict.getOrDefault("maxCo", 0.4, dimless, Range{0, 1, false, true});
    maxDeltaT =
        dict.getOrDefault("maxDeltaT", inf, dimTime, Range::positive());
}

void TimeControls::readWriting(const dictionary& dict)
{
    // adjustableRunTime is OpenFOAM's longer name of adjustable
    const int control = choice<int>
    (
        dict, "writeControl", "timeStep",
        {
            "timeStep", "runTime", "adjustable", "clockTime", "cpuTime",
            "adjustableRunTime"
        }
    );
    writeControl =
        control == 5 ? WriteControl::adjustable : WriteControl(control);

    const bool steps = writeControl == WriteControl::timeStep;
    writeInterval = dict.get
    (
        "writeInterval", steps ? dimless : dimTime, Range::positive()
    );
    if (steps && writeInterval != std::floor(writeInterval))
    {
        dict.fail
        (
            "writeInterval",
            "writeInterval " + dict.valueText("writeInterval")
          + " must be a whole number of steps with writeControl timeStep"
        );
    }
    purgeWrite = boundedLabel
    (
        dict, "purgeWrite", 0, 0, std::numeric_limits<label>::max()
    );
}

void TimeControls::readFormats(const dictionary& dict)
{
    writeAscii =
        dict.getChoiceOrDefault("writeFormat", "binary", {"binary", "ascii"})
     == "ascii";
    const word compression = dict.getChoiceOrDefault
    (
        "writeCompression", "off",
        {
            "off", "on", "no", "yes", "false", "true",
            "uncompressed", "compressed"
        }
    );
    writeCompressed =
        compression == "on" || compression == "yes" || compression == "true"
     || compression == "compressed";
    if (writeAscii && writeCompressed)
    {
        dict.fail
        (
            "writeCompression",
            "Text (writeFormat ascii) is written as it is: only writeFormat"
            " binary can be compressed"
        );
    }
    writePrecision = boundedLabel(dict, "writePrecision", 17, 1, 17);
    timeFormat = choice<TimeFormat>
    (
        dict, "timeFormat", "general", {"general", "fixed", "scientific"}
    );
    timePrecision = boundedLabel(dict, "timePrecision", 6, 1, 17);
}

scalar TimeControls::grownDeltaT(const scalar stable) const
{
    return adjustTimeStep ? std::min(maxCo*stable, maxDeltaT) : deltaT;
}

word TimeControls::timeName(const scalar value, const label precision) const
{
    const char* format =
        timeFormat == TimeFormat::fixed ? "%.*f"
      : timeFormat == TimeFormat::scientific ? "%.*e" : "%.*g";
    const int length =
        std::snprintf(nullptr, 0, format, int(precision), value);
    word name(length + 1, '\0');
    std::snprintf(name.data(), name.size(), format, int(precision), value);
    name.resize(length);
    return name;
}

} // namespace sph
