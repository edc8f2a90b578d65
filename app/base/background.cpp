// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/background.h"

#include <QCoreApplication>
#include <QThreadPool>

namespace app {

namespace {

// Enough that no work has to wait for a thread: each of about ten owners runs one work at a time,
// and may have cancelled works that have not stopped yet.
constexpr int mostThreads = 64;

constexpr qint64 intervalMilliseconds = 50;

} // namespace

QThreadPool& backgroundThreads()
{
    static QThreadPool threads;
    static const bool once = [] {
        threads.setMaxThreadCount(mostThreads);
        qAddPostRoutine([] { threads.waitForDone(); });
        return true;
    }();
    static_cast<void>(once);
    return threads;
}

QThreadPool& paintingThreads()
{
    static QThreadPool threads;
    static const bool once = [] {
        qAddPostRoutine([] { threads.waitForDone(); });
        return true;
    }();
    static_cast<void>(once);
    return threads;
}

bool ProgressRelay::put(const Progress& progress)
{
    if (sinceLast_.isValid() && sinceLast_.elapsed() < intervalMilliseconds)
        return false;
    sinceLast_.start();
    const std::scoped_lock lock(lock_);
    latest_ = progress;
    return true;
}

Progress ProgressRelay::latest() const
{
    const std::scoped_lock lock(lock_);
    return latest_;
}

} // namespace app
