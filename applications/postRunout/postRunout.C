// postRunout: front, run-out, height, time of stopping and energies of a
// collapse from its written times, beside the published law.
//
// Reads   <time>/granular.vtp, or any .vtp files with U, rho and m
//         system/postRunoutDict (deposit/DepositGauge.H, runoutLaws/), e.g.
//
//             L0 0.0972; H0 0.0875; origin (0 0 0); side right;
//             thresholdByDx 0.5;
//             law Lube2005;  band { runout 0.10; height 0.05; }
//             picture { vectors yes; }    // functionObjects/pictureOptions.H
//
// Writes  postProcessing/postRunout/<first time>/runout.dat, summary.dat,
//         profile_<time>.dat; with -plot collapse.png, profile.png

#include "Report.H"
#include "pictures.H"
#include "settings.H"

#include "annotation/Specimen.H"
#include "annotation/writeEntries.H"
#include "functionObjects/pictureOptions.H"

#include <iostream>

using namespace sph;
namespace fs = std::filesystem;

static ParticlePicture::Options readPicture
(
    const dictionary& dict, const Particles& particles
)
{
    return readPictureOptions
    (
        dict.subOrEmptyDict({"picture", "what collapse.png shows"}), particles
    );
}


static const std::vector<CommandLine::Option> options
{
    {"dict", "file", "Dictionary instead of system/postRunoutDict"},
    {"time", "list", "Only these times: '0.05,0.1' or ranges '0:1'"},
    {"latestTime", "", "Only the last time"},
    {"noZero", "", "Without the time 0"},
    {"vtp", "files", "Read these .vtp files: 'a.vtp b.vtp'"},
    {"times", "list", "The times of the files, without TimeValue: '0,0.1'"},
    {"plot", "", "Make collapse.png and profile.png with gnuplot"},
    {"field", "name", "Colour collapse.png by this field"},
    {"check", "", "Exit with 1 if a value lies outside of its band"},
    {"listEntries", "", "List all entries of postRunoutDict and exit"}
};


static int listEntries()
{
    Specimen specimen(0.01);
    writeDictionary
    (
        std::cout, "system/postRunoutDict", "postRunout -listEntries",
        [&](const dictionary& dict)
        {
            const auto [rho0, g] = readMaterial
            (
                dict, "/dev/null", specimen.particles       // no case
            );
            const DepositGauge gauge(dict, specimen.particles, rho0, g);
            OutputFolder folder("", "", "");
            Report(dict, gauge, Energies(specimen.particles, g, rho0), folder);
            readPicture(dict, specimen.particles);
        }
    );
    return 0;
}


static int judge(const std::pair<label, label>& counts)
{
    const auto [passed, failed] = counts;
    if (passed + failed == 0)
    {
        throw Error
        (
            "Nothing to check: there is no law with a band for this case"
            "\n\nGive the entries law and band { runout 0.1; height 0.05; }"
        );
    }
    std::cout << passed << " passed, " << failed << " failed" << std::endl;
    return failed > 0 ? 1 : 0;
}


static int postRunout(int argc, char* argv[])
{
    const CommandLine args
    (
        argc, argv,
        "Run-out and deposit of a collapse, beside the published law.", options
    );
    if (args.found("listEntries"))
    {
        return listEntries();
    }
    const fs::path caseDir =
        args.found("vtp")
      ? fs::path(args.valueOr("case", ".")) : args.caseDir();
    args.printBanner();

    const RunoutDict dict = readRunoutDict(args, caseDir);
    const auto snapshots = findSnapshots(args, caseDir);
    const auto selected = selectSnapshots
    (
        snapshots, args.valueOr("time", ""),
        args.found("latestTime"), args.found("noZero")
    );

    Particles particles;
    snapshots.front().read(particles);
    const MaterialConstants material = readMaterial(*dict, caseDir, particles);
    const auto& [rho0, g] = material;
    const DepositGauge gauge(*dict, particles, rho0, g);

    OutputFolder folder(caseDir, "postRunout", selected.front().name);
    Report report(*dict, gauge, Energies(particles, g, rho0), folder);
    ParticlePicture::Options picture = readPicture(*dict, particles);
    if (args.found("field"))
    {
        picture.field = args.valueOr("field", "");
    }
    dict.refuseUnused();

    for (const Snapshot& snapshot : selected)
    {
        snapshot.read(particles);
        report.add
        (
            snapshot.time, snapshot.name, particles,
            Energies(particles, g, rho0)
        );
    }
    const auto counts = report.summarise();

    if (args.found("plot"))
    {
        drawCollapse(selected, gauge, report, picture, folder.path());
        drawProfiles(selected, gauge, report, folder.path());
    }
    std::cout << "Columns: " << folder.path().string() << "\n\n";
    const int status = args.found("check") ? judge(counts) : 0;
    std::cout << (args.found("check") ? "" : "End\n") << std::flush;
    return status;
}

int main(int argc, char* argv[])
{
    return runMain("postRunout", [&]{ return postRunout(argc, argv); });
}
