#include "lists.H"

#include "annotation/listEntries.H"
#include "functionObjects/FunctionObject.H"
#include "selection/Libraries.H"
#include "selection/listModels.H"

#include <iomanip>
#include <iostream>

namespace fs = std::filesystem;

namespace sph
{

std::vector<CommandLine::Option> listOptions()
{
    return
    {
        {"listModels", "", "list every selection table and exit"},
        {
            "listFunctionObjects", "",
            "list types of function objects, and those of the case, and exit"
        },
        {
            "listEntries", "name",
            "list all entries of a model, family or dictionary and exit"
        }
    };
}


// The entries of functions and their types
static void listFunctions(const fs::path& controlDict)
{
    std::error_code ignored;
    if (!fs::exists(controlDict, ignored))
    {
        return;
    }
    const auto dict = dictionary::fromFile(controlDict);
    const dictionary& functions = dict.subOrEmptyDict("functions");
    std::cout << "functions of system/controlDict\n";
    for (const word& name : functions.toc())
    {
        std::cout
            << "    " << std::left << std::setw(34) << name
            << functions.subDict(name).getOrDefault<word>("type", "") << '\n';
    }
    std::cout << '\n';
}


bool list(const CommandLine& args)
{
    const bool models = args.found("listModels");
    const bool functions = args.found("listFunctionObjects");
    const bool entries = args.found("listEntries");
    if (!models && !functions && !entries)
    {
        return false;
    }
    loadLibrariesOfCase(args.casePath());
    if (models)
    {
        listModels(std::cout);
    }
    if (functions)
    {
        listModels(std::cout, FunctionObject::family);
        listFunctions(args.casePath()/"system"/"controlDict");
    }
    if (entries)
    {
        listEntries(std::cout, args.value("listEntries"));
    }
    return true;
}

} // namespace sph
