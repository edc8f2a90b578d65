// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSemaphore>
#include <QThreadPool>

/// While it lives, no thread of the global pool is free.
class BusyThreads {
public:
    BusyThreads()
    {
        const int threads = QThreadPool::globalInstance()->maxThreadCount();
        for (int i = 0; i < threads; ++i)
            QThreadPool::globalInstance()->start([this] {
                begun_.release();
                go_.acquire();
            });
        begun_.acquire(threads);
    }
    ~BusyThreads()
    {
        go_.release(QThreadPool::globalInstance()->maxThreadCount());
        QThreadPool::globalInstance()->waitForDone();
    }

private:
    QSemaphore begun_, go_;
};
