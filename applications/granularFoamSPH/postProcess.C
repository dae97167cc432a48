#include "postProcess.H"

#include "functionObjects/FileFields.H"
#include "functionObjects/FunctionObject.H"
#include "runTime/TimeControls.H"
#include "scheme/Material.H"
#include "selection/Libraries.H"
#include "setup/readGravity.H"

#include <iostream>

namespace fs = std::filesystem;

namespace sph
{

std::vector<CommandLine::Option> postProcessOptions()
{
    return
    {
        {
            "postProcess", "",
            "execute function objects over written times and exit"
        },
        {"func", "name", "with -postProcess: only this function object"},
        {"time", "list", "with it: only these times: '0.05,0.1' or '0:1'"},
        {"latestTime", "", "with it: only the last time"},
        {"noZero", "", "with it: without the time 0"}
    };
}


bool postProcessing(const CommandLine& args)
{
    const bool given = args.found("postProcess");
    for (const word& option : wordList{"func", "time", "latestTime", "noZero"})
    {
        if (!given && args.found(option))
        {
            throw Error("The option -" + option + " goes with -postProcess");
        }
    }
    if (given && args.found("noFunctionObjects"))
    {
        throw Error("-noFunctionObjects leaves nothing to -postProcess");
    }
    return given;
}


// What -func names
static const dictionary& namedEntry
(
    const word& name, const dictionary& functions, dictionary& byType
)
{
    if (functions.isDict(name))
    {
        return functions.subDict(name);
    }
    const auto& types = SelectionTables::all()[FunctionObject::family];
    if (types.count(name) == 0)
    {
        wordList valid;
        for (const auto& [type, description] : types)
        {
            valid.push_back(type);
        }
        wordList all = functions.toc();
        all.insert(all.end(), valid.begin(), valid.end());
        const word guess = nearest(name, all);
        throw Error
        (
            "Unknown function object " + name
          + (guess.empty() ? "" : "; did you mean '" + guess + "'?")
          + "\n\nEntries of functions in controlDict :\n\n"
          + listOfWords(functions.toc()) + "\n\nTypes :\n\n"
          + listOfWords(valid)
        );
    }
    byType = dictionary::fromString("type " + name + ';', "-func " + name);
    return byType;
}


void postProcess(const CommandLine& args)
{
    const fs::path caseDir = args.caseDir();
    const auto controlDict =
        dictionary::fromFile(caseDir/"system"/"controlDict");
    const TimeControls controls(controlDict);
    loadLibraries(controlDict, caseDir);
    const auto properties =
        dictionary::fromFile(caseDir/"constant"/"granularProperties");

    const auto snapshots = selectSnapshots
    (
        caseSnapshots(caseDir), args.valueOr("time", ""),
        args.found("latestTime"), args.found("noZero")
    );
    FileFields files;
    Particles particles;
    files.read(snapshots.front(), particles);
    FunctionObjects objects
    ({
        caseDir, snapshots.front().name, readGravity(caseDir),
        Material::readRho0(properties), particles,
        nullptr, &files
    });

    const dictionary& functions = controlDict.subOrEmptyDict("functions");
    dictionary byType;
    if (args.found("func"))
    {
        const word name = args.value("func");
        const dictionary& entry = namedEntry(name, functions, byType);
        objects.add(name, entry);
        entry.refuseUnused();
        controlDict.markUsed("functions");
    }
    else if (functions.toc().empty())
    {
        throw Error
        (
            "There is nothing to execute: controlDict has no functions, and"
            " -func names none"
        );
    }
    else
    {
        objects.add(functions);
    }
    controlDict.refuseUnused();

    for (const Snapshot& snapshot : snapshots)
    {
        std::cout << "Time = " << snapshot.name << std::endl;
        if (&snapshot != &snapshots.front())
        {
            files.read(snapshot, particles);
        }
        objects.execute(snapshot.time);
    }
    objects.end();
}

} // namespace sph
