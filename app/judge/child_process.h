// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QProcess>

#include <optional>
#include <stop_token>
#include <sys/types.h>
#include <vector>

namespace app::plug_in {

/// How long to wait for output of a child. Processor time counts, which other programs cannot use
/// up; wall-clock time counts only while the child sleeps.
struct WaitLimits {
    double processorSeconds = 1;
    double wallSeconds = 5;
};

/// This program as a judge's child. Needs no event loop: only the waiting thread uses it. Its
/// destructor makes the child's supervisor (supervisor.h) kill the child and all processes that it
/// started.
class ChildProcess {
public:
    ChildProcess(const QString& program, const QStringList& arguments);
    ~ChildProcess();
    Q_DISABLE_COPY_MOVE(ChildProcess)

    void write(const QByteArray& bytes) { process_.write(bytes); }

    /// Stuck: it computes without end. Asleep: it waits and uses no processor time.
    enum class WaitResult : std::uint8_t { Came, Ended, Stuck, Asleep, Stopped };
    /// Waits until the library's process is known; call this first.
    WaitResult waitForStart(const WaitLimits& patience, const std::stop_token& stop);
    /// Waits until `bytes` bytes or a whole line can be read.
    WaitResult waitFor(qint64 bytes, const WaitLimits& patience, const std::stop_token& stop);
    WaitResult waitForLine(const WaitLimits& patience, const std::stop_token& stop);
    QByteArray read(qint64 bytes) { return process_.read(bytes); }
    QByteArray readLine() { return process_.readLine().trimmed(); }
    qint64 available() const { return process_.bytesAvailable(); }

    double processorSeconds() const; ///< used by the child; 0 after it ended
    QString printed() const { return QString::fromLocal8Bit(printed_); } ///< its first part
    bool crashed() const { return process_.exitStatus() == QProcess::CrashExit; }
    int exitCode() const { return process_.exitCode(); } ///< or the signal of a crash

private:
    template <class Predicate>
    WaitResult waitUntil(Predicate enough, const WaitLimits& patience, const std::stop_token& stop);
    void keepPrinted();
    bool isAsleep() const;

    QProcess process_;   ///< the supervisor
    qint64 group_;       ///< process group of the supervisor
    qint64 library_ = 0; ///< number of the process that loads the library; 0: not known yet
    QByteArray printed_;
};

} // namespace app::plug_in

namespace app::plug_in {

/// The children of this process, which must have a single thread, including ended children that
/// were not waited for. While processes start and end some may be missing: call it again.
std::vector<pid_t> ownChildren();

/// The same from the kernel's list; empty if there is no such list (a kernel without
/// CONFIG_PROC_CHILDREN).
std::optional<std::vector<pid_t>> listedChildren();

/// The same from the parent of every process in /proc, which takes longer.
std::vector<pid_t> scannedChildren();

} // namespace app::plug_in
