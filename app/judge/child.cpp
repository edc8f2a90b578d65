// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/judge/child.h"

#include "app/judge/child_race.h"
#include "app/judge/judgement.h"
#include "app/judge/library.h"
#include "app/judge/supervisor.h"

#include <QByteArray>
#include <QDir>
#include <QFile>

#include <bit>
#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <fstream>
#include <limits>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

namespace app::plug_in {
namespace {

constexpr rlim_t processorSeconds = 120, largestFile = 1 << 20;
constexpr rlim_t ownTasks = 256; ///< processes and threads that a library may start

void limit(__rlimit_resource what, rlim_t most)
{
    const rlimit both{most, most};
    ::setrlimit(what, &both);
}

#if defined __SANITIZE_ADDRESS__ || defined __SANITIZE_THREAD__ // they reserve terabytes
void limitMemory() {}
#else
/// The address space in use: the first number of statm, in pages.
rlim_t usedMemory()
{
    rlim_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * rlim_t(::sysconf(_SC_PAGESIZE));
}

void limitMemory() { limit(RLIMIT_AS, usedMemory() + memoryLimit); }
#endif

/// The current number of the user's processes and threads, for which the system has one common
/// limit.
rlim_t tasksOfTheUser()
{
    rlim_t count = 0;
    for (const QString& id : QDir(QStringLiteral("/proc")).entryList(QDir::Dirs)) {
        const QByteArray folder = "/proc/" + id.toLatin1();
        struct stat owner {};
        QFile stat(QString::fromLatin1(folder + "/stat"));
        if (!id.front().isDigit() || ::stat(folder.constData(), &owner) != 0
            || owner.st_uid != ::getuid() || !stat.open(QIODevice::ReadOnly))
            continue;
        const QByteArray all = stat.readAll(); // the name may contain spaces and brackets
        constexpr int threads = 17;            // field 20, counted after the name
        count += all.mid(all.lastIndexOf(')') + 2).split(' ').value(threads).toULong();
    }
    return count;
}

/// The limit of processes does not apply to root; the supervisor ends such processes afterwards.
void limitEverything()
{
    ::setsid(); // so that a signal to its group reaches no other process
    for (const int signal :
         {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP, SIGPIPE, SIGXFSZ, SIGXCPU})
        std::signal(signal, SIG_DFL); // the judge recognizes a crash by its signal
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_CPU, processorSeconds);
    limit(RLIMIT_FSIZE, largestFile);
    limit(RLIMIT_NPROC, tasksOfTheUser() + ownTasks);
    limitMemory();
}

/// The pipes to the judge, moved away from the library's standard input and output.
struct Pipes {
    FILE* in;
    int out;
};

Pipes pipesOfTheJudge()
{
    const Pipes pipes{::fdopen(::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 64), "rb"),
                      ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 64)};
    const int nothing = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
    ::dup2(nothing, STDIN_FILENO);
    ::dup2(STDERR_FILENO, STDOUT_FILENO);
    std::setvbuf(stdout, nullptr, _IOLBF, 0); // so that little is lost in a crash
    return pipes;
}

bool send(int out, const void* data, std::size_t size)
{
    return ::write(out, data, size) == ssize_t(size); // less than PIPE_BUF: all or nothing
}

Answer answerTo(const Question& question, Clip clip)
{
    constexpr double unwritten = std::numeric_limits<double>::quiet_NaN();
    constexpr std::size_t margin = 4;
    std::array<double, 4 + 2 * margin> room;
    room.fill(unwritten);
    const Question given = question; // a copy, in case the library changes its input
    Answer answer{};
    answer.returned = clip(&given.line.a.x, &given.window.min.x, room.data() + margin);
    for (std::size_t i = 0; i < room.size(); ++i)
        if (i >= margin && i < margin + 4)
            answer.visible[i - margin] = room[i];
        else if (std::bit_cast<std::uint64_t>(room[i]) != std::bit_cast<std::uint64_t>(unwritten))
            answer.wroteBeyond = 1;
    return answer;
}

/// Sends each answer at once, so that the judge knows on which line the library hangs: the first
/// one without an answer.
void answerAll(const Pipes& pipes, Clip clip)
{
    Question question;
    while (std::fread(&question, sizeof question, 1, pipes.in) == 1) {
        const Answer answer = answerTo(question, clip);
        if (!send(pipes.out, &answer, sizeof answer))
            return;
    }
}

} // namespace

bool isChild(const QStringList& arguments)
{
    return arguments.size() > 2 && arguments.first() == QLatin1StringView(childKey);
}

int runChild(const QStringList& arguments)
{
    forkUnderSupervisor();
    const Pipes pipes = pipesOfTheJudge();
    limitEverything();
    const std::string id = std::to_string(::getpid()) + '\n';
    if (!send(pipes.out, id.data(), id.size()))
        ::_exit(EXIT_FAILURE);
    const Library library = loaded(arguments[2].toLocal8Bit().constData());
    const std::string line =
        (library.clip ? hello::ready + (' ' + library.name) : library.error) + '\n';
    if (send(pipes.out, line.data(), line.size()) && library.clip) {
        if (arguments[1] == u"race")
            race(pipes.out, library, arguments.sliced(3));
        else
            answerAll(pipes, library.clip);
    }
    std::fflush(stdout);
    ::_exit(0); // no code of the library runs after this
}

} // namespace app::plug_in
