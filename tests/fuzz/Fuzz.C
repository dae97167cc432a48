#include "fuzz/Fuzz.H"

#include "fuzz/Mutator.H"
#include "primitives/error.H"

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <iostream>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

namespace sph
{

namespace
{

std::int64_t fromEnvironment(const char* name, const std::int64_t otherwise)
{
    const char* text = std::getenv(name);
    return text ? std::atoll(text) : otherwise;
}

// What a crash is to say
std::array<char, 200> present;

extern "C" void sayAndDie(const int signal)
{
    const char* const end = std::find(present.begin(), present.end(), '\0');
    if (::write(STDERR_FILENO, present.data(), end - present.data()) >= 0)
    {
        ::raise(signal);    // the handler is away
    }
}

// Tells of signals that end the program, on a stack of its own
class Watch
{
    std::array<char, 1 << 16> stack_;

public:
    Watch()
    {
        stack_t stack{};
        stack.ss_sp = stack_.data();
        stack.ss_size = stack_.size();
        ::sigaltstack(&stack, nullptr);
        struct sigaction action{};
        action.sa_handler = sayAndDie;
        action.sa_flags = SA_ONSTACK | SA_RESETHAND | SA_NODEFER;
        for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGABRT, SIGVTALRM})
        {
            ::sigaction(signal, &action, nullptr);
        }
#ifndef __SANITIZE_ADDRESS__
        rlimit memory{};
        ::getrlimit(RLIMIT_AS, &memory);
        memory.rlim_cur = addressSpace() + (std::size_t(1) << 30);
        ::setrlimit(RLIMIT_AS, &memory);
#endif
    }
    ~Watch()
    {
        limitTime(0);
        rlimit memory{};
        ::getrlimit(RLIMIT_AS, &memory);
        memory.rlim_cur = memory.rlim_max;
        ::setrlimit(RLIMIT_AS, &memory);
        for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGABRT, SIGVTALRM})
        {
            ::signal(signal, SIG_DFL);
        }
        stack_t none{};
        none.ss_flags = SS_DISABLE;
        ::sigaltstack(&none, nullptr);
    }

    // Processor time of the program from now on [s]
    static void limitTime(const long seconds)
    {
        itimerval timer{};
        timer.it_value.tv_sec = seconds;
        ::setitimer(ITIMER_VIRTUAL, &timer, nullptr);
    }

private:
    static std::size_t addressSpace()
    {
        std::size_t pages = 0;
        std::ifstream("/proc/self/statm") >> pages;
        return pages*std::size_t(::sysconf(_SC_PAGESIZE));
    }
};

} // namespace


void Fuzz::run(const std::string& name, const label defaultRuns) const
{
    const std::int64_t seed = fromEnvironment("SPH_FUZZ_SEED", 1);
    const std::int64_t first = fromEnvironment("SPH_FUZZ_FIRST", 0);
    const std::int64_t runs = fromEnvironment("SPH_FUZZ_RUNS", defaultRuns);
    ASSERT_FALSE(corpus.empty());

    std::int64_t accepted = 0, findings = 0;
    const Watch watch;
    for (std::int64_t k = first; k < first + runs && findings < 10; ++k)
    {
        std::snprintf
        (
            present.data(), present.size(),
            "\nfuzz: %s, SPH_FUZZ_SEED=%lld SPH_FUZZ_FIRST=%lld\n",
            name.c_str(), static_cast<long long>(seed),
            static_cast<long long>(k)
        );
        std::size_t source = 0;
        const std::string input = Mutator
        (
            corpus, words, std::uint64_t(seed)*0x9e3779b97f4a7c15 + k
        ).next(source);
        if (const char* file = std::getenv("SPH_FUZZ_SAVE"))
        {
            std::ofstream(file, std::ios::binary) << input;
        }
        Watch::limitTime(10);
        try
        {
            target(input, source);
            ++accepted;
        }
        catch (const Error&)
        {}
        catch (const std::exception& error)
        {
            ++findings;
            ADD_FAILURE() << present.data() << error.what();
        }
    }
    std::cout << name << ": " << runs << " executions, " << accepted
        << " accepted, " << findings << " findings\n";
}

} // namespace sph
