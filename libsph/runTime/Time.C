#include "runTime/TimeData.H"

#include "runTime/log.H"

#include <iostream>

namespace sph
{

Time::Time(const std::filesystem::path& caseDir)
{
    std::cout << "Create time\n" << std::endl;

    const std::filesystem::path file = caseDir/"system"/"controlDict";
    FileWatch watch(file);
    dictionary controlDict = dictionary::fromFile(file);
    if (findTimes(caseDir).empty())
    {
        controlDict.fail
        (
            "startFrom",
            "There is no time folder in " + caseDir.string()
          + "\n\nRun setParticles first: it makes the particles of the start"
            " time."
        );
    }
    data_ = std::make_unique<Data>
    (
        caseDir, std::move(controlDict), std::move(watch)
    );
}

Time::Time(const std::filesystem::path& caseDir, dictionary controlDict)
:
    data_
    (
        std::make_unique<Data>
        (
            caseDir, std::move(controlDict), FileWatch({})
        )
    )
{}

Time::~Time() = default;

const std::filesystem::path& Time::caseDir() const
{
    return data_->caseDir;
}

const dictionary& Time::controlDict() const
{
    return data_->controlDict();
}

scalar Time::value() const
{
    return data_->state.value;
}

scalar Time::startTime() const
{
    return data_->start.value;
}

scalar Time::endTime() const
{
    return data_->controls.endTime;
}

scalar Time::stopTime() const
{
    return data_->stopTime();
}

scalar Time::deltaT() const
{
    return data_->state.deltaT;
}

scalar Time::maxCo() const
{
    return data_->controls.maxCo;
}

bool Time::adjustTimeStep() const
{
    return data_->controls.adjustTimeStep;
}

bool Time::writeAscii() const
{
    return data_->controls.writeAscii;
}

bool Time::writeCompressed() const
{
    return data_->controls.writeCompressed;
}

label Time::writePrecision() const
{
    return data_->controls.writePrecision;
}

std::int64_t Time::index() const
{
    return data_->state.index;
}

word Time::timeName() const
{
    return data_->name;
}

word Time::timeName(const scalar value) const
{
    return data_->controls.timeName(value, data_->precision);
}

std::filesystem::path Time::timePath() const
{
    return data_->caseDir/data_->name;
}

word Time::startTimeName() const
{
    return data_->start.name;
}

bool Time::run() const
{
    return !data_->stopping && !data_->atEnd();
}

void Time::setDeltaT(const scalar stable)
{
    Data& d = *data_;
    if (!(stable > 0))
    {
        throw Error
        (
            "The stable time step is " + timeText(stable) + " s at time "
          + d.name + " s: the solution has diverged"
        );
    }
    if (!d.controls.adjustTimeStep)
    {
        d.checkFixedDeltaT(stable);
        d.state.deltaT = d.state.deltaTLimit = d.controls.deltaT;
        return;
    }
    d.warnOfManySteps(stable);
    d.state.deltaTLimit = d.limitedDeltaT(stable);
    d.state.deltaT = d.shortenedDeltaT(d.state.deltaTLimit);
    stepLog() << "deltaT = " << d.state.deltaT << '\n';
}

scalar Time::grownDeltaT(const scalar stable) const
{
    return data_->controls.grownDeltaT(stable);
}

void Time::advance()
{
    Data& d = *data_;
    d.readModified();

    const scalar previous = d.state.value;
    d.state.value = d.steppedValue();
    if (!(d.state.value > previous))
    {
        throw Error
        (
            "The time step " + timeText(d.state.deltaT)
          + " s is too small to be added to the time " + d.name + " s"
        );
    }
    ++d.state.index;
    d.stepped = true;
    d.rename(previous);
    d.decideWriteAndStop();
    stepLog() << "Time = " << d.name << "\n\n";
    d.answerSignals();
}

bool Time::loop(const scalar stable)
{
    if (!run())
    {
        return false;
    }
    setDeltaT(stable);
    advance();
    return true;
}

bool Time::writeTime() const
{
    if (data_->stepped)
    {
        data_->answerSignals();
    }
    return data_->writing;
}

void Time::stop(const std::string& reason)
{
    std::cout << "Stopping at time " << data_->name << ": " << reason << '\n';
    data_->writing = true;
    data_->stopping = true;
}

void Time::writeState(const std::filesystem::path& folder) const
{
    data_->state.write(folder);
}

void Time::wroteState()
{
    Data& d = *data_;
    if (d.controls.purgeWrite == 0 || d.name == d.start.name)
    {
        return;
    }
    if (d.written.empty() || d.written.back() != d.name)
    {
        d.written.push_back(d.name);
    }
    while (d.written.size() > std::size_t(d.controls.purgeWrite))
    {
        std::error_code error;
        std::filesystem::remove_all(d.caseDir/d.written.front(), error);
        if (error)
        {
            warning
            (
                "Cannot remove " + (d.caseDir/d.written.front()).string()
              + ": " + error.message()
            );
        }
        d.written.pop_front();
    }
}

void Time::printExecutionTime() const
{
    stepLog()
        << "ExecutionTime = " << cpuTime() << " s  ClockTime = "
        << std::int64_t(clockTime()) << " s\n" << std::endl;
}

scalar Time::cpuTime() const
{
    return Data::cpuTime();
}

scalar Time::clockTime() const
{
    return data_->clockTime();
}

} // namespace sph
