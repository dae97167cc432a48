#include "runTime/log.H"

#include <array>
#include <ctime>
#include <iostream>
#include <unistd.h>

#ifdef _OPENMP
#include <omp.h>
#endif

#ifndef SPH_VERSION
#define SPH_VERSION "unknown"
#endif

namespace sph
{

namespace
{

std::string localTime(const char* format)
{
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    localtime_r(&now, &parts);
    std::array<char, 64> text{};
    std::strftime(text.data(), text.size(), format, &parts);
    return text.data();
}

std::string hostName()
{
    std::array<char, 256> name{};
    gethostname(name.data(), name.size() - 1);
    return name.data();
}

int threads()
{
#ifdef _OPENMP
    return omp_get_max_threads();
#else
    return 1;
#endif
}

} // namespace


static bool muted = false;

std::ostream& stepLog()
{
    static std::ostream nobody(nullptr);
    return muted ? nobody : std::cout;
}

void muteStepLog(const bool mute)
{
    muted = mute;
}

void warning(const std::string& text)
{
    std::cout.flush();
    std::cerr << "--> FOAM Warning :\n    " << text << '\n' << std::endl;
}

std::string buildVersion()
{
#ifdef SPH_SINGLE
    return SPH_VERSION ", sums over pairs in single precision";
#else
    return SPH_VERSION;
#endif
}

void printBanner
(
    const std::string& commandLine, const std::filesystem::path& caseDir
)
{
    const std::string rule(75, '-');
    std::cout
        << "/*" << rule << "*\\\n"
        << "  granularFoamSPH: smoothed particle hydrodynamics of dry granular"
        << " flow\n"
        << "\\*" << rule << "*/\n"
        << "Build  : " << buildVersion() << '\n'
        << "Exec   : " << commandLine << '\n'
        << "Date   : " << localTime("%b %d %Y") << '\n'
        << "Time   : " << localTime("%H:%M:%S") << '\n'
        << "Host   : " << hostName() << '\n'
        << "PID    : " << getpid() << '\n'
        << "Case   : " << caseDir.string() << '\n'
        << "nProcs : " << threads() << '\n'
        << "\n// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * *"
        << " * * * * * //" << std::endl;
}

} // namespace sph
