#include "advise.H"

#include "advice/MeasuredScene.H"
#include "advice/knownLimits.H"
#include "dictionary/files.H"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace sph
{

CommandLine::Option adviseOption()
{
    return
    {
        "advise", "percent",
        "say which spacing and setting reach an error, and exit"
    };
}


static scalar wantedError(const std::string& text)
{
    std::size_t end = 0;
    scalar percent = 0;
    try
    {
        percent = std::stod(text, &end);
    }
    catch (const std::exception&)
    {
        end = 0;
    }
    if (end != text.size() || !(percent > 0) || !std::isfinite(percent))
    {
        throw Error
        (
            "-advise takes the wanted error in percent, greater than 0, not '"
          + text + "'"
        );
    }
    return percent;
}

static void describe(const CaseScene& scene)
{
    std::cout
        << "This case: " << scene.kind << ", H = " << scene.height
        << " m, L = " << scene.length << " m";
    if (scene.kind != "incline")
    {
        std::cout << ", a = H/L = " << scene.aspect();
    }
    std::cout
        << ",\n" << scene.across() << " particles across ("
        << (scene.kind == "incline" ? "H" : "the smaller of H and L")
        << "), " << scene.duration << " sqrt(H/g) long\n";
}

static std::string percent(const std::optional<scalar>& value)
{
    if (!value)
    {
        return "-";
    }
    std::ostringstream text;
    text << std::setprecision(3) << *value << " %";
    return text.str();
}

static void printRuns
(
    const MeasuredScene& nearest, const CaseScene& scene
)
{
    std::cout
        << "\nNearest scene that was measured: " << nearest.name() << " (a = "
        << nearest.aspect() << "),\nerrors against " << nearest.reference()
        << ", of mu(I) or water with\nthe recommended scheme. Times are scaled"
           " by particles and steps to this case, if it\nruns to its endTime,"
           " on one thread of the machine of the charts.\n\n" << std::left
        << std::setw(12) << "setting" << std::setw(8) << "across"
        << std::setw(11) << "particles" << std::setw(10) << "error"
        << std::setw(10) << "front" << std::setw(10) << "height"
        << "time [s]\n";
    for (const MeasuredRun& run : nearest.runs())
    {
        std::cout
            << std::setw(12) << run.setting << std::setw(8) << run.across
            << std::setw(11) << std::lround(scene.particles(run.across))
            << std::setw(10) << percent(run.error)
            << std::setw(10) << percent(run.front)
            << std::setw(10) << percent(run.height)
            << std::setprecision(2) << nearest.timeOf(scene, run)
            << std::setprecision(6) << '\n';
    }
}

// The lines by which a case takes a setting of etc/caseDicts
static void printIncludes(const word& setting, const CaseScene& scene)
{
    for
    (
        const std::string file :
        {
            "constant/granularProperties", "system/controlDict",
            "system/sphSchemes", "system/sphSolution"
        }
    )
    {
        const std::string name = "caseDicts/" + setting + '/'
          + std::filesystem::path(file).filename().string();
        if (!std::filesystem::exists(etcFolder()/name))
        {
            continue;
        }
        if (file == "constant/granularProperties" && !scene.linearKFactor)
        {
            std::cout
                << "    twice the K that it has    // in " << file << '\n';
            continue;
        }
        std::cout
            << "    #includeEtc \"" << name << "\"    // last in " << file
            << '\n';
    }
}

// The cheapest run of any setting within the error
static void recommend
(
    const MeasuredScene& nearest, const CaseScene& scene, const scalar wanted
)
{
    const MeasuredRun* best = nullptr;
    for (const MeasuredRun& run : nearest.runs())
    {
        const MeasuredRun* within =
            nearest.coarsestWithin(run.setting, wanted);
        if
        (
            within
         && (
                !best
             || nearest.timeOf(scene, *within) < nearest.timeOf(scene, *best)
            )
        )
        {
            best = within;
        }
    }
    std::cout << '\n';
    if (!best)
    {
        std::cout
            << "No measured run comes within " << wanted << " %: the finest"
               " ones above say how near\nthe method was seen to come.\n";
        return;
    }
    const scalar spacing = scene.smaller()/best->across;
    std::cout
        << "There " << wanted << " % in "
        << (
               nearest.kind() == "column" ? "front and height"
             : nearest.kind() == "incline" ? "the profile of the velocity"
             : "the speed of the front"
           )
        << " was reached by " << best->setting << " with\n" << best->across
        << " particles across, here about " << std::setprecision(2)
        << nearest.timeOf(scene, *best) << std::setprecision(6)
        << " s. In this case:\n\n    spacing  " << spacing
        << ";    // last in system/setParticlesDict\n";
    printIncludes(best->setting, scene);
    if (scene.kind == "incline" && scene.length < 12*spacing)
    {
        std::cout
            << "    a periodic length of " << 12*spacing << " m at least, in"
               " place of " << scene.length << " m\n";
    }
}

void advise(const CommandLine& args)
{
    for (const char* other : {"dry-run", "postProcess"})
    {
        if (args.found(other))
        {
            throw Error
            (
                std::string("-advise runs nothing: leave out -") + other
            );
        }
    }
    const scalar wanted = wantedError(args.value("advise"));
    const CaseScene scene = readCaseScene(args.caseDir());
    describe(scene);

    const auto scenes = readMeasuredScenes();
    const auto nearest = std::min_element
    (
        scenes.begin(), scenes.end(),
        [&](const MeasuredScene& a, const MeasuredScene& b)
        {
            return a.distance(scene) < b.distance(scene);
        }
    );
    if (nearest == scenes.end() || !std::isfinite(nearest->distance(scene)))
    {
        std::cout << "\nNothing like it was measured.\n";
    }
    else
    {
        printRuns(*nearest, scene);
        if (nearest->distance(scene) > std::log(2.5))
        {
            std::cout
                << "\nIts shape is far from that scene's: take the errors as a"
                   " hint only.\n";
        }
        recommend(*nearest, scene, wanted);
    }

    const auto limits = knownLimits(scene);
    std::cout
        << "\nOf the known limits that are looked for (see"
           " tutorials/charts/stability)"
        << (limits.empty() ? " none\nis met.\n" : ":\n");
    for (const std::string& limit : limits)
    {
        std::cout << "  - " << limit << '\n';
    }
}

} // namespace sph
