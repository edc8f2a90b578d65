// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/plug_in/child_process.h"

#include <QCoreApplication>
#include <QElapsedTimer>

#include <csignal>
#include <ctime>
#include <map>

namespace app::plug_in {
namespace {

struct PlugIn {
    Q_DECLARE_TR_FUNCTIONS(PlugIn)
};

constexpr int glance = 20; // milliseconds between two looks at the clocks
constexpr qsizetype mostPrinted = 2000;
constexpr qint64 mostUnread = 1 << 20; // of answers: more comes only of somebody who never stops

} // namespace

ChildProcess::ChildProcess(const QString& program, const QStringList& arguments)
{
    process_.start(program, arguments);
    group_ = process_.processId();
}

ChildProcess::~ChildProcess()
{
    if (group_ > 0)
        ::kill(pid_t(-group_), SIGKILL); // the child leads it, unless it has hardly begun
    process_.kill();
    process_.waitForFinished();
}

double ChildProcess::processorSeconds() const
{
    clockid_t clock{};
    timespec time{};
    const auto id = pid_t(process_.processId());
    if (id <= 0 || ::clock_getcpuclockid(id, &clock) != 0 || ::clock_gettime(clock, &time) != 0)
        return 0;
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

void ChildProcess::keepPrinted()
{
    const QByteArray more = process_.readAllStandardError();
    printed_ += more.left(std::max<qsizetype>(0, mostPrinted - printed_.size()));
}

template <class Enough>
ChildProcess::News ChildProcess::waitUntil(Enough enough, const Patience& patience,
                                           const std::stop_token& stop)
{
    QElapsedTimer wall;
    wall.start();
    double used = processorSeconds();
    qint64 had = available();
    while (!enough()) {
        if (stop.stop_requested())
            return News::Stopped;
        process_.waitForReadyRead(glance);
        keepPrinted();
        if (available() > mostUnread)
            return News::Stuck;
        if (available() != had) { // it moves
            had = available();
            wall.restart();
            used = processorSeconds();
        } else if (process_.state() == QProcess::NotRunning) {
            return News::Ended;
        } else if (processorSeconds() - used > patience.processorSeconds
                   || double(wall.elapsed()) > 1000 * patience.wallSeconds) {
            return News::Stuck;
        }
    }
    return News::Came;
}

ChildProcess::News ChildProcess::waitFor(qint64 bytes, const Patience& patience,
                                         const std::stop_token& stop)
{
    return waitUntil([&] { return available() >= bytes; }, patience, stop);
}

ChildProcess::News ChildProcess::waitForLine(const Patience& patience, const std::stop_token& stop)
{
    return waitUntil([&] { return process_.canReadLine(); }, patience, stop);
}

QString signalText(int signal)
{
    static const std::map<int, QString> words{
        {SIGSEGV, PlugIn::tr("it used memory that is not its own, or called itself without end "
                             "(SIGSEGV)")},
        {SIGBUS, PlugIn::tr("it used memory that is not there (SIGBUS)")},
        {SIGFPE, PlugIn::tr("it divided a whole number by zero (SIGFPE)")},
        {SIGABRT, PlugIn::tr("it gave up: abort, a failed assert or an exception (SIGABRT)")},
        {SIGILL, PlugIn::tr("it came to an instruction that this processor does not have "
                            "(SIGILL)")},
        {SIGXCPU, PlugIn::tr("it used up its time (SIGXCPU)")},
    };
    const auto found = words.find(signal);
    return found != words.end() ? found->second : PlugIn::tr("signal %1").arg(signal);
}

} // namespace app::plug_in
