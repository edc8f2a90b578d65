// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/judge/child_process.h"

#include <QElapsedTimer>
#include <QFile>

#include <charconv>
#include <csignal>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <unistd.h>

namespace app::plug_in {
namespace {

constexpr int glance = 20; // milliseconds between two readings of the clocks
constexpr qsizetype mostPrinted = 2000;
constexpr qint64 mostUnread = 1 << 20;  // bytes: only a library that never stops sends more
constexpr int supervisorsTime = 10'000; // milliseconds, more than the supervisor needs

} // namespace

ChildProcess::ChildProcess(const QString& program, const QStringList& arguments)
{
    process_.start(program, arguments);
    group_ = process_.processId();
}

/// The supervisor kills all processes of the library, even after the library has ended, and then
/// ends.
ChildProcess::~ChildProcess()
{
    process_.terminate();
    if (process_.waitForFinished(supervisorsTime))
        return;
    if (group_ > 0)
        ::kill(pid_t(-group_), SIGKILL); // the group of the supervisor
    process_.kill();
    process_.waitForFinished();
}

ChildProcess::WaitResult ChildProcess::waitForStart(const WaitLimits& patience,
                                                    const std::stop_token& stop)
{
    const WaitResult news = waitForLine(patience, stop);
    if (news == WaitResult::Came)
        library_ = readLine().toLongLong();
    return news;
}

/// Reads the third field of the process's line in /proc, after the name, which may contain
/// anything.
bool ChildProcess::isAsleep() const
{
    QFile stat(QStringLiteral("/proc/%1/stat").arg(library_));
    if (library_ <= 0 || !stat.open(QIODevice::ReadOnly))
        return true;
    const QByteArray line = stat.readAll();
    return line.mid(line.lastIndexOf(')') + 2, 1) != "R";
}

double ChildProcess::processorSeconds() const
{
    clockid_t clock{};
    timespec time{};
    const auto id = pid_t(library_ > 0 ? library_ : process_.processId());
    if (id <= 0 || ::clock_getcpuclockid(id, &clock) != 0 || ::clock_gettime(clock, &time) != 0)
        return 0;
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

void ChildProcess::keepPrinted()
{
    const QByteArray more = process_.readAllStandardError();
    printed_ += more.left(std::max<qsizetype>(0, mostPrinted - printed_.size()));
}

template <class Predicate>
ChildProcess::WaitResult ChildProcess::waitUntil(Predicate enough, const WaitLimits& patience,
                                                 const std::stop_token& stop)
{
    QElapsedTimer wall;
    wall.start();
    double used = processorSeconds();
    qint64 had = available();
    while (!enough()) {
        if (stop.stop_requested())
            return WaitResult::Stopped;
        process_.waitForReadyRead(glance);
        keepPrinted();
        if (available() > mostUnread)
            return WaitResult::Stuck;
        if (available() != had) { // there is progress
            had = available();
            wall.restart();
            used = processorSeconds();
        } else if (process_.state() == QProcess::NotRunning) {
            return WaitResult::Ended;
        } else if (processorSeconds() - used > patience.processorSeconds) {
            return WaitResult::Stuck;
        } else if (!isAsleep()) { // it computes, or waits for a processor
            wall.restart();
        } else if (double(wall.elapsed()) > 1000 * patience.wallSeconds) {
            return WaitResult::Asleep;
        }
    }
    return WaitResult::Came;
}

ChildProcess::WaitResult ChildProcess::waitFor(qint64 bytes, const WaitLimits& patience,
                                               const std::stop_token& stop)
{
    return waitUntil([&] { return available() >= bytes; }, patience, stop);
}

ChildProcess::WaitResult ChildProcess::waitForLine(const WaitLimits& patience,
                                                   const std::stop_token& stop)
{
    return waitUntil([&] { return process_.canReadLine(); }, patience, stop);
}

} // namespace app::plug_in

namespace app::plug_in {
namespace {

/// Reads the fourth field of the process's line in /proc, after the name, which may contain
/// anything; 0 if the process has ended.
pid_t parentOf(pid_t process)
{
    std::ifstream stat("/proc/" + std::to_string(process) + "/stat");
    const std::string line(std::istreambuf_iterator<char>(stat), {});
    const std::size_t name = line.rfind(')');
    if (name == std::string::npos)
        return 0;
    std::istringstream fields(line.substr(name + 1));
    char state = 0;
    pid_t parent = 0;
    return fields >> state >> parent ? parent : 0;
}

} // namespace

std::optional<std::vector<pid_t>> listedChildren()
{
    std::ifstream list("/proc/self/task/" + std::to_string(::getpid()) + "/children");
    if (!list)
        return std::nullopt;
    return std::vector<pid_t>(std::istream_iterator<pid_t>(list), {});
}

std::vector<pid_t> scannedChildren()
{
    std::vector<pid_t> found;
    std::error_code error;
    std::filesystem::directory_iterator entry("/proc", error);
    for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        pid_t process = 0;
        const auto read = std::from_chars(name.data(), name.data() + name.size(), process);
        if (read.ec == std::errc() && read.ptr == name.data() + name.size()
            && parentOf(process) == ::getpid())
            found.push_back(process);
    }
    return found;
}

std::vector<pid_t> ownChildren()
{
    auto listed = listedChildren();
    return listed ? std::move(*listed) : scannedChildren();
}

} // namespace app::plug_in
