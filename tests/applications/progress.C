// The line that a terminal shows while a run goes, through a pseudo-terminal.
#include "applications/AppCase.H"

#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <unistd.h>

using namespace sph;

namespace
{

// granularFoamSPH with a terminal of its own
class Terminal
{
    ::pid_t pid_;
    int master_ = -1;
    bool ended_ = false;

public:
    std::string text;

    explicit Terminal(const AppCase& where, unsigned short columns = 100)
    {
        winsize size{25, columns, 0, 0};
        pid_ = ::forkpty(&master_, nullptr, nullptr, &size);
        if (pid_ < 0)
        {
            throw std::runtime_error("cannot fork");    // -1 is everybody
        }
        if (pid_ == 0)
        {
            const std::string app = SPH_BIN_DIR "/granularFoamSPH";
            const std::string dir = where.dir().string();
            ::execl
            (
                app.c_str(), app.c_str(), "-case", dir.c_str(),
                static_cast<char*>(nullptr)
            );
            ::_exit(2);
        }
    }

    ~Terminal()
    {
        if (!ended_)
        {
            ::kill(pid_, SIGKILL);
            ::waitpid(pid_, nullptr, 0);
        }
        ::close(master_);
    }

    // Reads until part has been said; false at the end of the output
    bool waitFor(const std::string& part)
    {
        std::array<char, 4096> piece{};
        while (!contains(text, part))
        {
            pollfd wait{master_, POLLIN, 0};
            const ssize_t n =
                ::poll(&wait, 1, 60000) == 1
              ? ::read(master_, piece.data(), piece.size()) : 0;
            if (n <= 0)
            {
                return false;
            }
            text.append(piece.data(), std::size_t(n));
        }
        return true;
    }

    void type(const char key) const
    {
        EXPECT_EQ(::write(master_, &key, 1), 1);
    }

    // Reads to the end; the exit code
    int end()
    {
        waitFor("there is no such text");
        int status = 0;
        ::waitpid(pid_, &status, 0);
        ended_ = true;
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

    // What stands on the screen in the end, line by line
    std::string screen() const
    {
        std::string lines, line;
        std::size_t column = 0;
        for (std::size_t i = 0; i < text.size(); ++i)
        {
            if (text[i] == '\n')
            {
                lines += line + '\n';
                line.clear();
                column = 0;
            }
            else if (text[i] == '\r')
            {
                column = 0;
            }
            else if (text.compare(i, 3, "\033[K") == 0)
            {
                line.resize(column);
                i += 2;
            }
            else
            {
                line.resize(std::max(line.size(), column + 1), ' ');
                line[column++] = text[i];
            }
        }
        return lines + line;
    }
};

// There may be no pseudo-terminals, as in a chroot without /dev/pts
struct progress : testing::Test
{
    void SetUp() override
    {
        const int master = ::posix_openpt(O_RDWR | O_NOCTTY);
        const char* name = master < 0 || ::grantpt(master) != 0
         || ::unlockpt(master) != 0 ? nullptr : ::ptsname(master);
        const bool there = name && ::access(name, R_OK | W_OK) == 0;
        ::close(master);
        if (!there)
        {
            GTEST_SKIP() << "No pseudo-terminals here";
        }
    }
};

} // namespace

TEST_F(progress, aTerminalGetsOneLine)
{
    const AppCase where;
    where.succeed("setParticles");
    Terminal terminal(where);
    EXPECT_EQ(terminal.end(), 0);
    const std::string screen = terminal.screen();
    EXPECT_CONTAINS(screen, "\n100 %  Time = 0.02 of 0.02 s  ");
    EXPECT_CONTAINS(screen, " particle-steps/s\n");
    EXPECT_CONTAINS(screen, "\nEnd\n");
    for (const char* step : {"\nTime = ", "Courant", "ExecutionTime", "deltaT"})
    {
        EXPECT_FALSE(contains(screen, step)) << step;
    }
}

TEST_F(progress, itIsUpdatedInPlaceAndEndsCleanlyAtCtrlC)
{
    const AppCase where;
    where.set("system/controlDict", "endTime", "1000");
    where.replace("system/controlDict", "stopWhenAtRest\\s*\\{", "$& enabled no;");
    where.succeed("setParticles");
    Terminal terminal(where);
    ASSERT_TRUE(terminal.waitFor(" left")) << terminal.text;
    ASSERT_TRUE(terminal.waitFor("0 %  Time = "));
    terminal.type('\003');
    EXPECT_EQ(terminal.end(), 0);
    const std::string screen = terminal.screen();
    EXPECT_CONTAINS(screen, "\nSignal INT: writing time ");
    EXPECT_CONTAINS(screen, "\n  0 %  Time = ");
    EXPECT_CONTAINS(screen, "\nEnd\n");
    EXPECT_FALSE(contains(screen, "^C"));
    EXPECT_FALSE(contains(screen, " left"));
    const auto first = screen.find(" of 1000 s");
    EXPECT_EQ(screen.find(" of 1000 s", first + 1), std::string::npos);
}

TEST_F(progress, itFitsANarrowTerminal)
{
    const AppCase where;
    where.succeed("setParticles");
    Terminal terminal(where, 20);
    EXPECT_EQ(terminal.end(), 0);
    EXPECT_CONTAINS(terminal.screen(), "\n100 %  Time = 0.02 \n");
}

TEST_F(progress, whatHasNoEndShowsNoShare)
{
    const AppCase where;
    where.set("system/controlDict", "stopAt", "nextWrite");
    where.set("system/controlDict", "writeControl", "timeStep");
    where.set("system/controlDict", "writeInterval", "20");
    where.succeed("setParticles");
    Terminal terminal(where);
    EXPECT_EQ(terminal.end(), 0);
    const std::string screen = terminal.screen();
    EXPECT_CONTAINS(screen, "\nTime = ");
    EXPECT_CONTAINS(screen, " particle-steps/s\n");
    EXPECT_FALSE(contains(screen, " %  Time"));
}

TEST_F(progress, aPipeGetsPlainLines)
{
    const AppCase where;
    where.succeed("setParticles");
    const std::string log = where.succeed("granularFoamSPH").text;
    EXPECT_CONTAINS(log, "\nCourant Number mean: ");
    EXPECT_CONTAINS(log, "\nExecutionTime = ");
    EXPECT_FALSE(contains(log, "\r"));
    EXPECT_FALSE(contains(log, "particle-steps/s"));
}
