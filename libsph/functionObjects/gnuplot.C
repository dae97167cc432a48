#include "functionObjects/gnuplot.H"

#include "runTime/log.H"

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <sys/wait.h>

namespace sph
{

static std::string shellQuoted(const std::string& text)
{
    std::string quoted = "'";
    for (const char c : text)
    {
        quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    return quoted + "'";
}


static bool gnuplotThere()
{
    return std::system("command -v gnuplot > /dev/null 2>&1") == 0;
}


bool runGnuplot(const std::filesystem::path& script)
{
    const std::string folder = script.parent_path().string();
    const std::string name = script.filename().string();
    if (!gnuplotThere())
    {
        static bool warned = false;
        if (!warned)
        {
            warned = true;
            warning
            (
                "gnuplot is not there: no pictures are made. The scripts are"
                " kept, the first is\n    " + script.string()
              + "\nOn Debian: apt-get install gnuplot-nox"
            );
        }
        return false;
    }

    const std::filesystem::path log = script.string() + ".log";
    const int status = std::system
    (
        (
            "cd " + shellQuoted(folder.empty() ? "." : folder)
          + " && gnuplot " + shellQuoted(name)
          + " > " + shellQuoted(log.filename().string()) + " 2>&1"
        ).c_str()
    );
    const bool ok = WIFEXITED(status) && WEXITSTATUS(status) == 0;
    if (!ok)
    {
        std::ostringstream text;
        text << std::ifstream(log).rdbuf();
        warning("gnuplot failed on " + script.string() + "\n" + text.str());
    }
    std::filesystem::remove(log);
    return ok;
}


std::string gnuplotText(const std::string& text)
{
    std::string safe;
    for (const char c : text)
    {
        if (c == '\'')
        {
            safe += '\'';
        }
        else if (c == '_' || c == '^' || c == '{' || c == '}' || c == '@')
        {
            safe += '\\';
        }
        safe += c;
    }
    return safe;
}

} // namespace sph
