// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recovery/signal_watch.h"

#include <QtGlobal>

#if defined(Q_OS_UNIX)
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
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

// A handler sees nothing but these. A process that is forked, and does not yet run another program,
// has them as well, but is not meant.
std::atomic<int> pipeEnd = -1;
std::atomic<pid_t> watched = 0;

void tellPipe(int signal)
{
    const int before = errno;
    const auto number = static_cast<unsigned char>(signal);
    if (getpid() == watched) [[maybe_unused]]
        const auto written = write(pipeEnd, &number, 1);
    errno = before;
}

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

/// The first signal that comes; nothing more is to come: 0.
int nextSignal(int pipe)
{
    unsigned char number = noMore;
    while (read(pipe, &number, 1) < 0 && errno == EINTR) {
    }
    return number;
}

} // namespace

struct SignalWatch::Parts {
    std::array<int, 2> pipe{-1, -1};
    std::vector<std::pair<int, struct sigaction>> before;
    std::thread thread;
};

// The thread takes no signals itself: the handler may then run in any other.
SignalWatch::SignalWatch(std::function<void(int signal)> last) : parts_(std::make_unique<Parts>())
{
    if (pipe(parts_->pipe.data()) != 0)
        return;
    for (const int end : parts_->pipe)
        fcntl(end, F_SETFD, FD_CLOEXEC);
    sigset_t all, old;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &old);
    parts_->thread = std::thread([end = parts_->pipe[0], last = std::move(last)] {
        if (const int signal = nextSignal(end); signal != noMore) {
            last(signal);
            dieOf(signal);
        }
    });
    pipeEnd = parts_->pipe[1];
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
    pthread_sigmask(SIG_SETMASK, &old, nullptr);
}

SignalWatch::~SignalWatch()
{
    for (const auto& [signal, action] : parts_->before)
        sigaction(signal, &action, nullptr);
    if (!parts_->thread.joinable())
        return;
    [[maybe_unused]] const auto written = write(parts_->pipe[1], &noMore, 1);
    parts_->thread.join(); // it waits for this byte, or the process is about to end
    pipeEnd = -1;
    for (const int end : parts_->pipe)
        close(end);
}

#else

struct SignalWatch::Parts {};
SignalWatch::SignalWatch(std::function<void(int)>) {}
SignalWatch::~SignalWatch() = default;

#endif

} // namespace app
