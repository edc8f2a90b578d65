// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/background.h"

#include <QSemaphore>
#include <QThreadPool>

/// While it lives, no painting thread is free.
class BusyThreads {
public:
    BusyThreads()
    {
        const int threads = app::paintingThreads().maxThreadCount();
        for (int i = 0; i < threads; ++i)
            app::paintingThreads().start([this] {
                begun_.release();
                go_.acquire();
            });
        begun_.acquire(threads);
    }
    ~BusyThreads()
    {
        go_.release(app::paintingThreads().maxThreadCount());
        app::paintingThreads().waitForDone();
    }

private:
    QSemaphore begun_, go_;
};
