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
    const dictionary& dict, const Key& key,
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
    dict.fail(key.name, "Unknown " + key.name + ' ' + name);
}

} // namespace


TimeControls::TimeControls(const dictionary& dict)
{
    readStartAndStop(dict);
    readStep(dict);
    readWriting(dict);
    readFormats(dict);

    runTimeModifiable = dict.getOrDefault<bool>
    (
        {"runTimeModifiable", "this file is read again when it was edited"},
        true
    );

    const Key application
    (
        "application", "solver of the case, for Allrun", "granularFoamSPH"
    );
    if (dict.found(application))
    {
        dict.get<word>(application);
    }
}

void TimeControls::readStartAndStop(const dictionary& dict)
{
    startFrom = choice<StartFrom>
    (
        dict, {"startFrom", "time folder to start from"}, "latestTime",
        {"firstTime", "startTime", "latestTime"}
    );
    startTime =
        startFrom == StartFrom::startTime
      ? dict.get({"startTime", "time to start from", "0"}, dimTime)
      : dict.getOrDefault
        (
            {"startTime", "time that setParticles writes"}, 0, dimTime
        );

    stopAt = choice<StopAt>
    (
        dict, {"stopAt", "when to stop"}, "endTime",
        {"endTime", "writeNow", "noWriteNow", "nextWrite"}
    );
    endTime =
        stopAt == StopAt::endTime
      ? dict.get({"endTime", "end of the run", "1"}, dimTime)
      : dict.getOrDefault
        (
            {"endTime", "end of the run"},
            std::numeric_limits<scalar>::infinity(), dimTime
        );
}

void TimeControls::readStep(const dictionary& dict)
{
    const scalar inf = std::numeric_limits<scalar>::infinity();

    adjustTimeStep = dict.getOrDefault<bool>
    (
        {"adjustTimeStep", "steps follow maxCo and the limits of stability"},
        false
    );
    const Key first
    (
        "deltaT", "the step; with adjustTimeStep the first", "1e-5"
    );
    deltaT =
        adjustTimeStep && !dict.found(first)
      ? 0
      : dict.get(first, dimTime, Range::positive());
    maxCo = dict.getOrDefault
    (
        {"maxCo", "Courant number of steps that are adjusted"}, 0.4,
        dimless, Range{0, 1, false, true}
    );
    maxDeltaT = dict.getOrDefault
    (
        {"maxDeltaT", "greatest step that is adjusted"}, inf,
        dimTime, Range::positive()
    );
}

void TimeControls::readWriting(const dictionary& dict)
{
    // adjustableRunTime is OpenFOAM's longer name of adjustable
    const int control = choice<int>
    (
        dict, {"writeControl", "what writeInterval counts"}, "timeStep",
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
        steps
      ? Key("writeInterval", "steps from write to write", "1000")
      : Key("writeInterval", "time from write to write", "0.05"),
        steps ? dimless : dimTime, Range::positive()
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
    purgeWrite = dict.getLabelOrDefault
    (
        {"purgeWrite", "time folders of this run to keep; 0: all"}, 0, Range{0}
    );
}

void TimeControls::readFormats(const dictionary& dict)
{
    writeAscii =
        dict.getChoiceOrDefault
        (
            {"writeFormat", "format of the files of the particles"},
            "binary", {"binary", "ascii"}
        )
     == "ascii";
    const word compression = dict.getChoiceOrDefault
    (
        {"writeCompression", "zlib compression of binary files"}, "off",
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
    writePrecision = dict.getLabelOrDefault
    (
        {"writePrecision", "digits of ascii files"}, 17, Range::between(1, 17)
    );
    timeFormat = choice<TimeFormat>
    (
        dict, {"timeFormat", "notation of the names of time folders"},
        "general",
        {"general", "fixed", "scientific"}
    );
    timePrecision = dict.getLabelOrDefault
    (
        {"timePrecision", "digits of the names of time folders"}, 6,
        Range::between(1, 17)
    );
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
