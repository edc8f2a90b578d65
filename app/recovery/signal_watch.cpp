// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recovery/signal_watch.h"

#include <QtGlobal>

#if defined(Q_OS_UNIX)
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <system_error>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>
#endif

namespace app {

#if defined(Q_OS_UNIX)

namespace {

constexpr std::array deadly{SIGTERM, SIGHUP, SIGINT};
constexpr unsigned char noMore = 0; // no signal has this number

// The only data that a handler reads. A forked process that has not yet started another program has
// this data as well, but must not act on it.
std::atomic<int> pipeEnd = -1;
std::atomic<pid_t> watched = 0;
static_assert(decltype(pipeEnd)::is_always_lock_free && decltype(watched)::is_always_lock_free,
              "a handler must not wait for the thread that it interrupts");

void tellPipe(int signal)
{
    const int before = errno;
    const auto number = static_cast<unsigned char>(signal);
    if (const int end = pipeEnd; end >= 0 && getpid() == watched) [[maybe_unused]]
        const auto written = write(end, &number, 1);
    errno = before;
}

/// One for each process, never closed: a handler that is still running in another thread would
/// write into the file that gets the same number next.
class Pipe {
public:
    Pipe() = default;

    /// Opens it if necessary; returns whether it is open. After a fork, the parent's pipe is not
    /// used.
    bool open()
    {
        if (owner_ == getpid())
            return true;
        if (pipe2(ends_.data(), O_CLOEXEC) != 0)
            return false;
        fcntl(writeEnd(), F_SETFL, O_NONBLOCK); // a handler must not wait until the thread reads
        owner_ = getpid();
        return true;
    }
    int readEnd() const { return ends_[0]; }
    int writeEnd() const { return ends_[1]; }

private:
    std::array<int, 2> ends_{-1, -1};
    pid_t owner_ = 0;
};

Pipe pipeToThread;

/// During its lifetime, this thread and the threads that it starts receive no signals.
class NoSignals {
public:
    NoSignals()
    {
        sigset_t all;
        sigfillset(&all);
        pthread_sigmask(SIG_SETMASK, &all, &before_);
    }
    ~NoSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    Q_DISABLE_COPY_MOVE(NoSignals)

private:
    sigset_t before_;
};

[[noreturn]] void dieOf(int signal)
{
    struct sigaction usual {};
    usual.sa_handler = SIG_DFL;
    sigaction(signal, &usual, nullptr);
    sigset_t only;
    sigemptyset(&only);
    sigaddset(&only, signal);
    pthread_sigmask(SIG_UNBLOCK, &only, nullptr);
    kill(getpid(), signal);
    _exit(128 + signal);
}

/// The first signal that arrives; 0 at the end.
int nextSignal(int pipe)
{
    unsigned char number = noMore;
    while (read(pipe, &number, 1) < 0 && errno == EINTR) {
    }
    return number;
}

/// Waits for a signal, which then ends the process, or for the end of the watch.
void waitForSignal(int pipe, const std::function<void(int signal)>& last)
{
    if (const int signal = nextSignal(pipe); signal != noMore) {
        last(signal);
        dieOf(signal);
    }
}

} // namespace

struct SignalWatch::Parts {
    std::vector<std::pair<int, struct sigaction>> before;
    std::thread thread;
};

// The thread itself receives no signals: the handler may run in any other thread.
SignalWatch::SignalWatch(std::function<void(int signal)> last) : parts_(std::make_unique<Parts>())
{
    if (!pipeToThread.open())
        return;
    const NoSignals guard;
    try {
        parts_->thread = std::thread(
            [end = pipeToThread.readEnd(), last = std::move(last)] { waitForSignal(end, last); });
    } catch (const std::system_error&) {
        return; // no more threads: signals end the process as usual
    }
    pipeEnd = pipeToThread.writeEnd();
    watched = getpid();
    for (const int signal : deadly) {
        struct sigaction action {
        }, usual{};
        action.sa_handler = tellPipe;
        action.sa_flags = SA_RESTART;
        sigaction(signal, nullptr, &usual);
        if (usual.sa_handler == SIG_IGN)
            continue;
        sigaction(signal, &action, nullptr);
        parts_->before.emplace_back(signal, usual);
    }
}

SignalWatch::~SignalWatch()
{
    for (const auto& [signal, action] : parts_->before)
        sigaction(signal, &action, nullptr);
    if (!parts_->thread.joinable())
        return;
    pipeEnd = -1;
    // A full pipe contains signals, so the process is about to end. The same usually holds if a
    // signal precedes this byte.
    [[maybe_unused]] const auto written = write(pipeToThread.writeEnd(), &noMore, 1);
    parts_->thread.join();
}

#else

struct SignalWatch::Parts {};
SignalWatch::SignalWatch(std::function<void(int)>) {}
SignalWatch::~SignalWatch() = default;

#endif

} // namespace app
