#include "postProcess.H"

#include "functionObjects/FileFields.H"
#include "functionObjects/FunctionObject.H"
#include "rheology/Rheology.H"
#include "runTime/TimeControls.H"
#include "scheme/Material.H"
#include "selection/Libraries.H"
#include "setup/readGravity.H"

#include <algorithm>
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
        {"funcs", "list", "with it: only these function objects: '(a b)'"},
        {"time", "list", "with it: only these times: '0.05,0.1' or '0:1'"},
        {"latestTime", "", "with it: only the last time"},
        {"noZero", "", "with it: without the time 0"}
    };
}


bool postProcessing(const CommandLine& args)
{
    const bool given = args.found("postProcess");
    for
    (
        const word& option :
        wordList{"func", "funcs", "time", "latestTime", "noZero"}
    )
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


// What -func and -funcs name
static wordList namedObjects(const CommandLine& args)
{
    wordList names;
    if (args.found("func"))
    {
        names.push_back(args.value("func"));
    }
    if (args.found("funcs"))
    {
        const auto list = dictionary::fromString
        (
            "funcs " + args.value("funcs") + ';', "-funcs"
        ).get<wordList>("funcs");
        if (list.empty())
        {
            throw Error("-funcs names no function object");
        }
        names.insert(names.end(), list.begin(), list.end());
    }
    for (auto name = names.begin(); name != names.end(); ++name)
    {
        if (std::find(names.begin(), name, *name) != name)
        {
            throw Error("The function object " + *name + " is named twice");
        }
    }
    return names;
}


// The entry of that name, or one that is made for the type of that name
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
    const vector g = readGravity(caseDir);
    const scalar rho0 = Material::readRho0(properties);
    const auto eos = EquationOfState::New
    (
        properties, "equationOfState", rho0, g.norm()
    );
    const auto rheology = Rheology::New(properties, "rheology", *eos);
    FunctionObjects objects
    ({
        caseDir, snapshots.front().name, g, rho0, particles, nullptr, &files,
        rheology.get()
    });

    const dictionary& functions = controlDict.subOrEmptyDict("functions");
    const wordList names = namedObjects(args);
    std::vector<dictionary> byType(names.size());
    for (std::size_t k = 0; k < names.size(); ++k)
    {
        const dictionary& entry = namedEntry(names[k], functions, byType[k]);
        objects.add(names[k], entry);
        entry.refuseUnused();
    }
    if (!names.empty())
    {
        controlDict.markUsed("functions");
    }
    else if (functions.toc().empty())
    {
        throw Error
        (
            "There is nothing to execute: controlDict has no functions, and"
            " -func or -funcs names none"
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
