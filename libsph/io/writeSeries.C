// VTK/<case>.vtp.series: the times of a case for ParaView.
#include "io/caseIO.H"

#include "primitives/writeFile.H"
#include "runTime/Time.H"

#include <iomanip>
#include <ostream>

namespace sph
{

namespace
{

void writeSeries
(
    const std::filesystem::path& caseDir,
    const std::filesystem::path& series, const std::string& member
)
{
    std::vector<Time::Instant> times;
    for (const Time::Instant& time : Time::findTimes(caseDir))
    {
        if (std::filesystem::exists(caseDir/time.name/member))
        {
            times.push_back(time);
        }
    }
    if (times.empty())
    {
        std::error_code ignored;
        std::filesystem::remove(series, ignored);
        return;
    }

    writeFile
    (
        series,
        [&](std::ostream& os)
        {
            os  << std::setprecision(15)
                << "{\n  \"file-series-version\": \"1.0\",\n  \"files\": [";
            const char* separator = "\n";
            for (const Time::Instant& time : times)
            {
                os  << separator << "    {\"name\": \"../" << time.name << '/'
                    << member << "\", \"time\": " << time.value << '}';
                separator = ",\n";
            }
            os << "\n  ]\n}\n";
        }
    );
}

} // namespace


void writeSeries(const std::filesystem::path& caseDir)
{
    std::filesystem::path dir =
        std::filesystem::absolute(caseDir).lexically_normal();
    if (!dir.has_filename())
    {
        dir = dir.parent_path();
    }
    const std::string name = dir.filename().string();
    writeSeries(dir, dir/"VTK"/(name + ".vtp.series"), "granular.vtp");
    writeSeries(dir, dir/"VTK"/(name + "Walls.vtp.series"), "walls.vtp");
}

} // namespace sph
