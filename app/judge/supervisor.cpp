// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/judge/supervisor.h"

#include "app/judge/child_process.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <fcntl.h>
#include <initializer_list>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace app::plug_in {
namespace {

constexpr timespec shortWait{0, 5'000'000}; ///< until a killed process has ended
constexpr int mostWaits = 1000;             ///< some processes wait for a disk and end late

sigset_t setOf(std::initializer_list<int> some)
{
    sigset_t set;
    ::sigemptyset(&set);
    for (const int signal : some)
        ::sigaddset(&set, signal);
    return set;
}

void killChildren()
{
    for (const pid_t one : ownChildren())
        ::kill(one, SIGKILL);
}

/// A child that has ended, with its status; 0 while all are running, -1 if there is none.
pid_t reap(int& status)
{
    pid_t ended = ::waitpid(-1, &status, WNOHANG);
    while (ended < 0 && errno == EINTR)
        ended = ::waitpid(-1, &status, WNOHANG);
    return ended;
}

/// Kills repeatedly, because processes started by a killed process become children only then.
void killAll(pid_t library, int& statusOfLibrary)
{
    const sigset_t ended = setOf({SIGCHLD});
    for (int waits = 0; waits < mostWaits; ++waits) {
        killChildren();
        int status = 0;
        pid_t one = reap(status);
        for (; one > 0; one = reap(status))
            if (one == library)
                statusOfLibrary = status;
        if (one < 0)
            return; // there are no more children
        ::sigtimedwait(&ended, nullptr, &shortWait);
    }
}

/// Waits until the library's process has ended or the judge requests the end.
void waitFor(pid_t library, const sigset_t& wanted, int& statusOfLibrary)
{
    for (;;) {
        int status = 0;
        for (pid_t one = reap(status); one > 0; one = reap(status))
            if (one == library) {
                statusOfLibrary = status;
                return;
            }
        const int signal = ::sigwaitinfo(&wanted, nullptr);
        if (signal > 0 && signal != SIGCHLD)
            return;
    }
}

[[noreturn]] void endAs(int status)
{
    if (!WIFSIGNALED(status))
        ::_exit(WEXITSTATUS(status));
    const rlimit none{0, 0};
    ::setrlimit(RLIMIT_CORE, &none);
    std::signal(WTERMSIG(status), SIG_DFL);
    const sigset_t all = setOf({WTERMSIG(status)});
    ::sigprocmask(SIG_UNBLOCK, &all, nullptr);
    ::raise(WTERMSIG(status));
    ::_exit(EXIT_FAILURE);
}

/// Closes the pipes, so that the judge sees their ends when the library's process has ended.
void letPipesGo()
{
    const int nothing = ::open("/dev/null", O_RDWR | O_CLOEXEC);
    ::dup2(nothing, STDIN_FILENO);
    ::dup2(nothing, STDOUT_FILENO);
    ::dup2(nothing, STDERR_FILENO);
}

} // namespace

void forkUnderSupervisor()
{
    ::setsid(); // so that no signal of a terminal ends it before it has killed
    ::prctl(PR_SET_CHILD_SUBREAPER, 1);
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    for (const int signal : {SIGTERM, SIGCHLD, SIGHUP, SIGINT})
        std::signal(signal, SIG_DFL); // sigwait cannot receive ignored signals
    const sigset_t wanted = setOf({SIGTERM, SIGCHLD, SIGHUP, SIGINT});
    ::sigprocmask(SIG_BLOCK, &wanted, nullptr);
    const pid_t supervisor = ::getpid(), library = ::fork();
    if (library == 0) {
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);
        ::sigprocmask(SIG_UNBLOCK, &wanted, nullptr);
        if (::getppid() == supervisor)
            return;
        ::_exit(EXIT_FAILURE);
    }
    if (library < 0)
        ::_exit(EXIT_FAILURE);
    letPipesGo();
    int status = SIGKILL; // the status of a killed process, as from wait
    waitFor(library, wanted, status);
    killAll(library, status);
    endAs(status);
}

} // namespace app::plug_in
