#include "runTime/TimeData.H"

#include "runTime/log.H"

#include <algorithm>
#include <ctime>
#include <iostream>

namespace sph
{

namespace
{

// More digits than this show the rounding of multiples of writeInterval
constexpr label maxRaisedPrecision = 15;

} // namespace


Time::Data::Data
(
    const std::filesystem::path& caseDir,
    dictionary controlDict,
    FileWatch fileWatch
)
:
    caseDir(caseDir),
    watch(std::move(fileWatch)),
    controls(controlDict)
{
    dictionaries.push_back
    (
        std::make_unique<dictionary>(std::move(controlDict))
    );
    precision = controls.timePrecision;
    start = findStart();
    name = start.name;
    state.value = start.value;
    if (state.read(caseDir/start.name))
    {
        start.value = state.value;
        precision = std::max(precision, state.timePrecision);
    }
    else
    {
        state.deltaT = controls.deltaT;
        warnOfNewStart();
    }
    writeIndex = presentWriteIndex();

    if (atEnd())
    {
        warning
        (
            "endTime " + timeText(controls.endTime)
          + " is not after the start time " + start.name
          + ": there is nothing to do"
        );
    }
}

scalar Time::Data::clockTime() const
{
    return std::chrono::duration<scalar>(Clock::now() - begin).count();
}

scalar Time::Data::cpuTime()
{
    timespec used{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
    return used.tv_sec + 1e-9*used.tv_nsec;
}

Time::Instant Time::Data::findStart() const
{
    const std::vector<Instant> times = findTimes(caseDir);
    if (times.empty())
    {
        const scalar value = controls.startTime;
        return {value, controls.timeName(value, precision)};
    }
    if (controls.startFrom == TimeControls::StartFrom::firstTime)
    {
        return times.front();
    }
    if (controls.startFrom == TimeControls::StartFrom::latestTime)
    {
        return latestComplete(times);
    }

    std::string names;
    for (const Instant& time : times)
    {
        if (sameTime(time.value, controls.startTime))
        {
            return time;
        }
        names += ' ' + time.name;
    }
    controlDict().fail
    (
        "startTime",
        "There is no time folder " + timeText(controls.startTime) + " in "
      + caseDir.string() + "\n\nAvailable times :" + names
    );
}

// Not of the first time, nor of startTime: setParticles makes them
void Time::Data::warnOfNewStart() const
{
    const std::vector<Instant> times = findTimes(caseDir);
    const bool expected =
        times.empty() || start.name == times.front().name
     || sameTime(start.value, controls.startTime);
    if (!expected)
    {
        warning
        (
            "There is no " + start.name + "/uniform/time of this name: a new"
            " start from the particles\n    of this time, not a restart"
        );
    }
}

// A kill may have left a folder without granular.vtp, which is written last
Time::Instant Time::Data::latestComplete
(
    const std::vector<Instant>& times
) const
{
    std::string skipped;
    for (auto time = times.rbegin(); time != times.rend(); ++time)
    {
        if (std::filesystem::exists(caseDir/time->name/"granular.vtp"))
        {
            if (!skipped.empty())
            {
                warning
                (
                    "There is no granular.vtp in the time folders" + skipped
                  + ": starting from " + time->name
                );
            }
            return *time;
        }
        skipped += ' ' + time->name;
    }
    return times.back();
}

void Time::Data::decideWriteAndStop()
{
    const std::int64_t present = presentWriteIndex();
    writing = present > writeIndex;
    writeIndex = present;

    switch (controls.stopAt)
    {
        case TimeControls::StopAt::endTime:
            // Nothing is lost: the end is written, a write time or not
            writing = writing || atEnd();
            break;
        case TimeControls::StopAt::writeNow:
            writing = true;
            stopping = true;
            break;
        case TimeControls::StopAt::noWriteNow:
            writing = false;
            stopping = true;
            break;
        case TimeControls::StopAt::nextWrite:
            stopping = stopping || writing;
            break;
    }
}

void Time::Data::answerSignals()
{
    if (const char* signal = signals.takeStop())
    {
        std::cout
            << "Signal " << signal << ": writing time " << name
            << " and stopping" << std::endl;
        writing = true;
        stopping = true;
    }
    if (signals.takeWrite())
    {
        std::cout << "Signal USR1: writing time " << name << std::endl;
        writing = true;
    }
}

void Time::Data::rename(const scalar previousValue)
{
    const label before = precision;
    while
    (
        precision < maxRaisedPrecision
     && controls.timeName(state.value, precision)
     == controls.timeName(previousValue, precision)
    )
    {
        ++precision;
    }
    if (precision != before)
    {
        std::cout
            << "Raising timePrecision from " << before << " to " << precision
            << ": time names would coincide\n";
        state.timePrecision = precision;
    }
    name = controls.timeName(state.value, precision);
}

void Time::Data::readModified()
{
    if (!controls.runTimeModifiable || !watch.changed())
    {
        return;
    }
    std::cout
        << "Re-reading object controlDict from file " << controlDict().file()
        << std::endl;
    try
    {
        auto edited = std::make_unique<dictionary>
        (
            dictionary::fromFile(controlDict().file())
        );
        const TimeControls editedControls(*edited);

        // Whatever was there at the start has its reader
        wordList known = controlDict().toc();
        known.insert(known.end(), {"functions", "libs"});
        for (const word& key : known)
        {
            if (edited->found(key))
            {
                edited->markUsed(key);
            }
        }
        edited->refuseUnused();

        controls = editedControls;
        dictionaries.push_back(std::move(edited));
        precision = std::max(precision, controls.timePrecision);
        writeIndex = presentWriteIndex();
    }
    catch (const Error& error)
    {
        warning
        (
            "controlDict was edited, but cannot be used: the run goes on with"
            " the old values\n\n" + error.block()
        );
    }
}

} // namespace sph
