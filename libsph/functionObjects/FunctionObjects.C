#include "functionObjects/FunctionObject.H"

#include "deposit/magnitude.H"
#include "functionObjects/FileFields.H"
#include "primitives/writeFile.H"

#include <cmath>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace sph
{

const FieldInfo& findField
(
    const Scene& scene, const word& name,
    const dictionary& dict, const word& entry
)
{
    const FieldInfo& field = findField(scene.particles, name, dict, entry);
    if (scene.files)
    {
        scene.files->need(name, dict, entry);
    }
    return field;
}


namespace
{

// One entry of functions, and when it is due
struct Scheduled
{
    word name;
    std::unique_ptr<FunctionObject> object;
    word control;
    scalar interval;
    std::int64_t lastPeriod = 0;
    bool executed = false;      // at the present step

    Scheduled(const word& name, const dictionary& dict, const Scene& scene);

    bool due(const Time& runTime);
    void execute(Time& runTime);
};


Scheduled::Scheduled
(
    const word& name, const dictionary& dict, const Scene& scene
)
:
    name(name),
    object
    (
        FunctionObject::New
        (
            dict, {"type", "kind of function object"}, name, scene
        )
    ),
    control
    (
        dict.getChoiceOrDefault
        (
            {"executeControl", "what executeInterval counts"},
            object->defaultControl(), {"timeStep", "runTime", "writeTime"}
        )
    ),
    interval
    (
        control == "runTime"
      ? dict.get
        (
            {"executeInterval", "simulated time between calls", "0.01"},
            dimTime, Range::positive()
        )
      : dict.getLabelOrDefault
        (
            {"executeInterval", "steps, or writes, between calls"}, 1,
            Range{1}
        )
    )
{}


bool Scheduled::due(const Time& runTime)
{
    if (control == "timeStep")
    {
        return runTime.index() % std::int64_t(interval) == 0;
    }
    if (control == "writeTime" && !runTime.writeTime())
    {
        return false;
    }
    // writeTime counts the writes, runTime the intervals begun to half a step
    const std::int64_t period =
        control == "writeTime"
      ? lastPeriod + 1
      : std::floor((runTime.value() + 0.5*runTime.deltaT())/interval);
    const bool isDue =
        control == "writeTime"
      ? period % std::int64_t(interval) == 0 : period > lastPeriod;
    lastPeriod = period;
    return isDue;
}


void Scheduled::execute(Time& runTime)
{
    executed = true;
    std::string stop;
    object->execute(runTime.value(), stop);
    if (!stop.empty())
    {
        runTime.stop(name + ": " + stop);
    }
}

} // namespace


struct FunctionObjects::Data
{
    const Scene scene;
    std::vector<Scheduled> list;
    std::string states;     // of a last step, before what it adds

    std::string currentStates() const
    {
        std::ostringstream os;
        os << std::setprecision(17);
        for (const Scheduled& entry : list)
        {
            os  << entry.name << "\n{\n"
                << "    period          " << entry.lastPeriod << ";\n";
            entry.object->writeState(os);
            os  << "}\n\n";
        }
        return os.str();
    }
};


FunctionObjects::FunctionObjects(const Scene& scene)
:
    data_(new Data{scene, {}, {}})
{}


FunctionObjects::FunctionObjects
(
    const dictionary& controlDict, const Scene& scene
)
:
    FunctionObjects(scene)
{
    add
    (
        controlDict.subOrEmptyDict
        ({
            "functions", "function objects, each with a name: see"
            " functionObject", "{ energies { type energies; } }"
        })
    );
}


void FunctionObjects::add(const word& name, const dictionary& dict)
{
    data_->list.emplace_back(name, dict, data_->scene);
}


void FunctionObjects::add(const dictionary& functions)
{
    for (const word& name : functions.toc())
    {
        const dictionary& dict = functions.subDict(name);
        if (dict.getOrDefault({"enabled", "no: as if it were not there"}, true))
        {
            add(name, dict);
        }
        else
        {
            functions.markUsed(name);
        }
    }
}


FunctionObjects::~FunctionObjects() = default;


void FunctionObjects::execute(Time& runTime, const bool start)
{
    for (Scheduled& entry : data_->list)
    {
        entry.executed = false;
        if (entry.due(runTime) || start)
        {
            entry.execute(runTime);
        }
    }
    // The last state belongs to every record; a run that goes on from here
    // shall not know that it was the last
    if (!start && !runTime.run())
    {
        data_->states = data_->currentStates();
        for (Scheduled& entry : data_->list)
        {
            if (!entry.executed)
            {
                entry.execute(runTime);
            }
        }
    }
}


void FunctionObjects::execute(const scalar time)
{
    for (Scheduled& entry : data_->list)
    {
        std::string stop;
        entry.object->execute(time, stop);
        if (!stop.empty())
        {
            std::cout << entry.name << ": " << stop << '\n';
        }
    }
}


static std::filesystem::path stateFile(const std::filesystem::path& timeFolder)
{
    return timeFolder/"uniform"/"functionObjects";
}


void FunctionObjects::write(const std::filesystem::path& timeFolder) const
{
    if (data_->list.empty())
    {
        return;
    }
    writeFile
    (
        stateFile(timeFolder),
        [&](std::ostream& os)
        {
            os  << "FoamFile\n{\n"
                << "    version     2.0;\n"
                << "    format      ascii;\n"
                << "    class       dictionary;\n"
                << "    location    \""
                << timeFolder.filename().string() << "/uniform\";\n"
                << "    object      functionObjects;\n"
                << "}\n\n"
                << (
                        data_->states.empty()
                      ? data_->currentStates() : data_->states
                    )
                // A file that was cut short has no such entry
                << "count           " << data_->list.size() << ";\n";
        }
    );
}


void FunctionObjects::read
(
    const std::filesystem::path& timeFolder, const Time& runTime
)
{
    for (Scheduled& entry : data_->list)
    {
        entry.due(runTime);
    }
    const std::filesystem::path file = stateFile(timeFolder);
    if (!std::filesystem::exists(file))
    {
        return;
    }
    const dictionary states = dictionary::fromFile(file);
    states.get<label>("count");
    for (Scheduled& entry : data_->list)
    {
        if (states.isDict(entry.name))
        {
            const dictionary& state = states.subDict(entry.name);
            entry.lastPeriod = std::int64_t
            (
                state.get("period", dimless, Range::between(-9e15, 9e15))
            );
            entry.object->readState(state);
            state.refuseUnused();
        }
    }
}


void FunctionObjects::end()
{
    for (Scheduled& entry : data_->list)
    {
        entry.object->end();
    }
}

} // namespace sph
