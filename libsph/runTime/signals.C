#include "runTime/signals.H"

namespace sph
{

namespace
{

constexpr std::array<int, 3> caught{SIGINT, SIGTERM, SIGUSR1};

volatile std::sig_atomic_t stopSignal = 0;
volatile std::sig_atomic_t writeSignal = 0;

extern "C" void noteSignal(const int signal)
{
    if (signal == SIGUSR1)
    {
        writeSignal = 1;
    }
    else
    {
        stopSignal = signal;
    }
}

} // namespace


SignalHandlers::SignalHandlers()
{
    stopSignal = 0;
    writeSignal = 0;
    for (std::size_t i = 0; i < caught.size(); ++i)
    {
        struct sigaction action{};
        action.sa_handler = noteSignal;
        sigemptyset(&action.sa_mask);
        action.sa_flags = SA_RESTART;
        if (caught[i] == SIGINT)
        {
            action.sa_flags |= SA_RESETHAND;
        }
        sigaction(caught[i], &action, &previous_[i]);
    }
}

SignalHandlers::~SignalHandlers()
{
    for (std::size_t i = 0; i < caught.size(); ++i)
    {
        sigaction(caught[i], &previous_[i], nullptr);
    }
}

const char* SignalHandlers::takeStop()
{
    const int signal = stopSignal;
    stopSignal = 0;
    return signal == 0 ? nullptr : signal == SIGINT ? "INT" : "TERM";
}

bool SignalHandlers::takeWrite()
{
    const bool asked = writeSignal != 0;
    writeSignal = 0;
    return asked;
}

} // namespace sph
