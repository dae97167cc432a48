#include "deposit/Snapshots.H"

#include "deposit/selectTimes.H"
#include "io/caseIO.H"
#include "io/vtkFields.H"

#include <algorithm>
#include <sstream>
#include <unistd.h>
#include <vtkFieldData.h>

namespace fs = std::filesystem;

namespace sph
{

namespace
{

// A time folder of one foreign file, for as long as this lives
class LinkedFolder
{
    const fs::path folder_ =
        fs::temp_directory_path()/("postRunout." + std::to_string(getpid()));

public:
    explicit LinkedFolder(const fs::path& file)
    {
        fs::create_directories(folder_);
        fs::create_symlink(fs::absolute(file), folder_/"granular.vtp");
    }
    ~LinkedFolder()
    {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
    LinkedFolder(const LinkedFolder&) = delete;
    LinkedFolder& operator=(const LinkedFolder&) = delete;

    const fs::path& path() const { return folder_; }
};


scalar timeValue(const fs::path& path)
{
    const VtkFile file(path, "");
    vtkDataArray* array = file.data->GetFieldData()->GetArray("TimeValue");
    if (!array || array->GetNumberOfValues() < 1)
    {
        file.fail
        (
            "The field data TimeValue is missing: say the times of the files"
            " with -times"
        );
    }
    return array->GetComponent(0, 0);
}

} // namespace


void Snapshot::read(Particles& particles) const
{
    if (path.extension() != ".vtp")
    {
        readState(path, particles);
        return;
    }
    const LinkedFolder folder(path);
    try
    {
        readState(folder.path(), particles);
    }
    catch (const IOError& error)
    {
        throw IOError(error.what(), path.string());
    }
}


std::vector<Snapshot> caseSnapshots(const fs::path& caseDir)
{
    std::vector<Snapshot> snapshots;
    for (const Time::Instant& time : Time::findTimes(caseDir))
    {
        const fs::path folder = caseDir/time.name;
        if (fs::exists(folder/"granular.vtp"))
        {
            snapshots.push_back({time.value, time.name, folder});
        }
    }
    if (snapshots.empty())
    {
        throw Error
        (
            "No time folder of " + caseDir.string() + " holds a granular.vtp"
            "\n\nRun setParticles and granularFoamSPH first"
        );
    }
    return snapshots;
}


std::vector<Snapshot> fileSnapshots
(
    const std::string& files, const std::vector<scalar>& times
)
{
    std::vector<Snapshot> snapshots;
    std::istringstream names(files);
    for (std::string name; names >> name; )
    {
        if (!fs::is_regular_file(name))
        {
            throw Error("There is no file " + name);
        }
        const std::size_t i = snapshots.size();
        const scalar time =
            times.empty() ? timeValue(name) : i < times.size() ? times[i] : 0;
        std::ostringstream text;
        text << time;
        snapshots.push_back({time, text.str(), name});
    }
    if
    (
        snapshots.empty()
     || (!times.empty() && times.size() != snapshots.size())
    )
    {
        throw Error
        (
            std::to_string(snapshots.size()) + " files and "
          + std::to_string(times.size()) + " times are given: there must be a"
            " file, and a time for each"
        );
    }
    std::sort
    (
        snapshots.begin(), snapshots.end(),
        [](const Snapshot& a, const Snapshot& b) { return a.time < b.time; }
    );
    return snapshots;
}


std::vector<Snapshot> selectSnapshots
(
    const std::vector<Snapshot>& snapshots,
    const std::string& list, const bool latest, const bool noZero
)
{
    std::vector<Time::Instant> times;
    for (const Snapshot& snapshot : snapshots)
    {
        if (!noZero || snapshot.time != 0)
        {
            times.push_back({snapshot.time, snapshot.name});
        }
    }
    if (times.empty())
    {
        throw Error("No time is left to look at without the time 0");
    }
    if (!list.empty())
    {
        times = selectTimes(times, list);
    }
    if (latest)
    {
        times.erase(times.begin(), times.end() - 1);
    }

    std::vector<Snapshot> selected;
    for (const Snapshot& snapshot : snapshots)
    {
        const auto same = [&](const Time::Instant& time)
        {
            return time.name == snapshot.name;
        };
        if (std::any_of(times.begin(), times.end(), same))
        {
            selected.push_back(snapshot);
        }
    }
    return selected;
}

} // namespace sph
