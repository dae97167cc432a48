#include "benchmarks/machine.H"

#include <cstdio>
#include <ctime>
#include <fstream>
#include <memory>

namespace sph
{

std::string date()
{
    const std::time_t now = std::time(nullptr);
    char text[32];
    std::strftime(text, sizeof(text), "%FT%TZ", std::gmtime(&now));
    return text;
}

// The commit, with a plus if files have been changed since
std::string version()
{
    const std::string command =
        "GIT_OPTIONAL_LOCKS=0 git -C '" SPH_PROJECT_ROOT "' status"
        " --porcelain=v2 --branch --untracked-files=no 2>/dev/null";
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe
    (
        popen(command.c_str(), "r"), pclose
    );
    std::string commit = "unknown";
    bool changed = false;
    char line[4096];
    while (pipe && std::fgets(line, sizeof(line), pipe.get()))
    {
        const std::string text = line, key = "# branch.oid ";
        if (text.compare(0, key.size(), key) == 0)
        {
            commit = text.substr(key.size(), 10);
        }
        changed = changed || text[0] != '#';
    }
    return commit + (changed ? "+" : "");
}

std::string compiler()
{
#ifdef __clang__
    return __VERSION__;
#else
    return "GCC " __VERSION__;
#endif
}

std::string processor()
{
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
    {
        const auto colon = line.find(": ");
        if (line.compare(0, 10, "model name") == 0 && colon != line.npos)
        {
            return line.substr(colon + 2);
        }
    }
    return "unknown";
}

} // namespace sph
