#include "benchmarks/history.H"

#include "benchmarks/machine.H"
#include "particles/lanes.H"
#include "primitives/error.H"

#include <omp.h>

#include <cmath>
#include <fstream>
#include <sstream>

namespace sph
{

void appendToHistory
(
    const std::filesystem::path& file, const Figures& figures
)
{
    std::ostringstream header, line;
    header << "date,version,compiler,lanes,processor,processors";
    line << date() << ',' << version() << ",\"" << compiler() << "\","
        << width<lanes> << ",\"" << processor() << "\","
        << omp_get_num_procs();
    for (const auto& [name, value] : figures)
    {
        header << ",\"" << name << '"';
        line << ',';
        if (std::isfinite(value))
        {
            line << value;
        }
    }

    std::string text = line.str() + '\n', first;
    if (!std::getline(std::ifstream(file), first))
    {
        text = header.str() + '\n' + text;
    }
    else if (first != header.str())
    {
        throw Error
        (
            "The history " + file.string() + " has other columns: move it"
            " away, or name another file with --history"
        );
    }
    std::ofstream out(file, std::ios::app);
    if (!out.write(text.data(), std::streamsize(text.size())).flush())
    {
        throw Error("Cannot write the history " + file.string());
    }
}

} // namespace sph
