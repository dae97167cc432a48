#include "runTime/Progress.H"

#include "runTime/log.H"

#include <chrono>
#include <cmath>
#include <cstring>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <sys/ioctl.h>
#include <unistd.h>

namespace sph
{

namespace
{

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds interval{200};

const char* const erase = "\r\033[K";

// Erases the line before anything else is written
class AboveLine : public std::streambuf
{
    std::ostream& stream_;
    std::streambuf* const to_;
    std::streambuf* const terminal_;
    bool& drawn_;

public:
    // terminal: what std::cout wrote to before
    AboveLine(std::ostream& stream, std::streambuf* terminal, bool& drawn)
    :
        stream_(stream),
        to_(stream.rdbuf(this)),
        terminal_(terminal),
        drawn_(drawn)
    {}

    ~AboveLine() override { stream_.rdbuf(to_); }

private:
    void eraseLine()
    {
        if (drawn_)
        {
            drawn_ = false;
            terminal_->sputn(erase, std::streamsize(std::strlen(erase)));
            terminal_->pubsync();
        }
    }

    int_type overflow(const int_type c) override
    {
        eraseLine();
        return to_->sputc(traits_type::to_char_type(c));
    }

    std::streamsize xsputn(const char* text, std::streamsize n) override
    {
        eraseLine();
        return to_->sputn(text, n);
    }

    int sync() override { return to_->pubsync(); }
};

std::size_t columns()
{
    winsize size{};
    const bool known =
        ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
    return known ? size.ws_col : 80;
}

// "0:32", "2:05:09"
std::string durationText(const scalar seconds)
{
    const auto s = std::int64_t(std::ceil(seconds));
    std::ostringstream os;
    os << std::setfill('0');
    if (s >= 3600)
    {
        os << s/3600 << ':' << std::setw(2);
    }
    os << s/60 % 60 << ':' << std::setw(2) << s % 60;
    return os.str();
}

} // namespace


struct Progress::Line
{
    const Time& runTime;
    const label particles;
    const Clock::time_point begin = Clock::now();
    Clock::time_point lastDrawn = begin;
    std::int64_t steps = 0;
    bool drawn = false;
    std::streambuf* const terminal = std::cout.rdbuf();
    AboveLine out{std::cout, terminal, drawn};
    AboveLine err{std::cerr, terminal, drawn};

    Line(const Time& runTime, const label particles)
    :
        runTime(runTime),
        particles(particles)
    {
        muteStepLog(true);
    }

    ~Line()
    {
        draw(text());
        drawn = false;
        std::cout << std::endl;
        muteStepLog(false);
    }

    scalar elapsed() const      // [s]
    {
        return std::chrono::duration<scalar>(Clock::now() - begin).count();
    }

    // Of the time to the end; 0 where there is none
    scalar part() const
    {
        const scalar start = runTime.startTime();
        return (runTime.value() - start)/(runTime.stopTime() - start);
    }

    std::string text() const
    {
        std::ostringstream os;
        if (part() > 0)
        {
            os  << std::setw(3) << std::floor(100*std::min(part(), 1.0))
                << " %  ";
        }
        os << "Time = " << runTime.timeName();
        if (part() > 0)
        {
            os << " of " << runTime.stopTime();
        }
        os  << " s  " << std::setprecision(2) << steps/elapsed()*particles
            << " particle-steps/s";
        return os.str();
    }

    std::string timeLeft() const
    {
        const scalar p = part();
        return
            p > 0 && p < 1
          ? "  " + durationText(elapsed()*(1/p - 1)) + " left" : "";
    }

    void draw(const std::string& text)
    {
        const std::string line = erase + text.substr(0, columns() - 1);
        terminal->sputn(line.data(), std::streamsize(line.size()));
        terminal->pubsync();
        drawn = true;
    }
};


Progress::Progress(const Time& runTime, const label particles)
{
    if (::isatty(STDOUT_FILENO))
    {
        line_ = std::make_unique<Line>(runTime, particles);
    }
}

Progress::~Progress() = default;

void Progress::step()
{
    if (!line_)
    {
        return;
    }
    ++line_->steps;
    const auto now = Clock::now();
    if (now - line_->lastDrawn >= interval)
    {
        line_->lastDrawn = now;
        line_->draw(line_->text() + line_->timeLeft());
    }
}

} // namespace sph
