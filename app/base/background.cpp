// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/background.h"

#include <QCoreApplication>
#include <QThreadPool>

namespace app {

namespace {

// No work waits for another one's thread: each of some ten owners has one running work, and perhaps
// cancelled ones that are about to stop.
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
