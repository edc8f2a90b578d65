// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QProcess>

#include <stop_token>

namespace app::plug_in {

/// How long nothing may come of a child. What counts is the processor's time, which other programs
/// do not use up; the clock on the wall only while it sleeps.
struct Patience {
    double processorSeconds = 1;
    double wallSeconds = 5;
};

/// This program as the child of a judge. Needs no event loop: it belongs to the thread that waits.
/// When it goes, the child and what that started are killed by the child's warden (warden.h).
class ChildProcess {
public:
    ChildProcess(const QString& program, const QStringList& arguments);
    ~ChildProcess();
    Q_DISABLE_COPY_MOVE(ChildProcess)

    void write(const QByteArray& bytes) { process_.write(bytes); }

    /// Stuck: it works without an end. Asleep: it waits for something, and uses no processor.
    enum class News : std::uint8_t { Came, Ended, Stuck, Asleep, Stopped };
    /// Until the process of the library is known: before all else.
    News waitForStart(const Patience& patience, const std::stop_token& stop);
    /// Until `bytes` can be read, or a whole line.
    News waitFor(qint64 bytes, const Patience& patience, const std::stop_token& stop);
    News waitForLine(const Patience& patience, const std::stop_token& stop);
    QByteArray read(qint64 bytes) { return process_.read(bytes); }
    QByteArray readLine() { return process_.readLine().trimmed(); }
    qint64 available() const { return process_.bytesAvailable(); }

    double processorSeconds() const; ///< that it has used; 0 once it ended
    QString printed() const { return QString::fromLocal8Bit(printed_); } ///< the first of it
    bool crashed() const { return process_.exitStatus() == QProcess::CrashExit; }
    int exitCode() const { return process_.exitCode(); } ///< or the signal of a crash

private:
    template <class Enough>
    News waitUntil(Enough enough, const Patience& patience, const std::stop_token& stop);
    void keepPrinted();
    bool isAsleep() const;

    QProcess process_;   ///< the warden
    qint64 group_;       ///< of the warden
    qint64 library_ = 0; ///< the number of the process that loads the library; 0: not known yet
    QByteArray printed_;
};

} // namespace app::plug_in
