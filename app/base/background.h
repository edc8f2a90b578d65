// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/progress.h"

#include <QElapsedTimer>
#include <QFutureWatcher>
#include <QPromise>
#include <QScopeGuard>
#include <QtConcurrent/QtConcurrentRun>

#include <chrono>
#include <climits>
#include <memory>
#include <mutex>
#include <semaphore>

class QThreadPool;

namespace app {

/// The threads of all background work but painting: minutes of measuring must not keep the canvas
/// from painting. ~QCoreApplication waits for them.
QThreadPool& backgroundThreads();
/// The threads that clip and paint, as many as the processor has. They are not those of the global
/// pool: QPainter divides the scaling of an image among these, and waits for them, so that zooming
/// held the canvas until a picture was painted. ~QCoreApplication waits for them.
QThreadPool& paintingThreads();

/// Passes progress from the working thread to another, at most 20 times a second.
class ProgressRelay {
public:
    bool put(const Progress& progress); ///< false: too soon after the last one
    Progress latest() const;

private:
    mutable std::mutex lock_;
    Progress latest_{};
    QElapsedTimer sinceLast_; ///< of the working thread
};

/// One piece of work at a time, on another thread: `Result work(const Follower&)`. It must own
/// everything it uses, because cancelled work continues until it next checks its stop token. The
/// owner's thread gets progress and result as events, or by waiting. Neither cancel() nor the
/// destructor waits, and nothing is delivered after them. Both may be called during a delivery. The
/// work should not throw: an exception becomes a QUnhandledException where the result would arrive.
template <class Result>
class Background {
public:
    /// The threads must outlive it.
    explicit Background(QThreadPool& threads = backgroundThreads());
    ~Background() { cancel(); }
    Q_DISABLE_COPY_MOVE(Background)

    using Done = std::function<void(Result)>;
    using Progressed = std::function<void(const Progress&)>;

    /// Cancels the current work, if any. The new one begins when the old one has stopped.
    template <class Work>
    void start(Work work, Done done, Progressed progressed = {});
    bool active() const { return job_ != nullptr; } ///< started, and neither done nor cancelled
    void cancel();
    /// Asks the work to stop early; its result is still delivered.
    void requestStop();
    /// Waits for the result at most that long, and delivers it before it returns. Returns false if
    /// the time was too short.
    bool waitFor(std::chrono::microseconds time);
    void wait(); ///< however long it takes

private:
    /// Shared with the working thread.
    struct Job {
        std::stop_source stop;
        ProgressRelay relay;
        std::binary_semaphore finished{0};
    };
    void deliver();

    QThreadPool& threads_;
    std::shared_ptr<Job> job_; ///< null: not active
    Done done_;
    Progressed progressed_;
    std::shared_ptr<std::mutex> alone_ = std::make_shared<std::mutex>(); ///< held while one works
    QFutureWatcher<Result> watcher_;
};

template <class Result>
Background<Result>::Background(QThreadPool& threads) : threads_(threads)
{
    QObject::connect(&watcher_, &QFutureWatcherBase::finished, &watcher_, [this] { deliver(); });
    QObject::connect(&watcher_, &QFutureWatcherBase::progressValueChanged, &watcher_, [this] {
        if (!job_ || !progressed_)
            return;
        const auto progressed = progressed_; // it may cancel
        progressed(job_->relay.latest());
    });
}

template <class Result>
template <class Work>
void Background<Result>::start(Work work, Done done, Progressed progressed)
{
    cancel();
    job_ = std::make_shared<Job>();
    done_ = std::move(done);
    progressed_ = std::move(progressed);
    watcher_.setFuture(
        QtConcurrent::run(&threads_, [job = job_, alone = alone_,
                                      work = std::move(work)](QPromise<Result>& promise) mutable {
            const std::scoped_lock lock(*alone);
            if (promise.isCanceled())
                return;
            const auto finished = qScopeGuard([&] { job->finished.release(); });
            promise.setProgressRange(0, INT_MAX);
            const auto tell = [&, told = 0](const Progress& progress) mutable {
                if (job->relay.put(progress))
                    promise.setProgressValue(++told);
            };
            promise.addResult(work(Follower{job->stop.get_token(), tell}));
        }));
}

template <class Result>
void Background<Result>::cancel()
{
    if (!job_)
        return;
    job_->stop.request_stop();
    job_.reset();
    done_ = {};
    progressed_ = {};
    watcher_.cancel();
}

template <class Result>
void Background<Result>::requestStop()
{
    if (job_)
        job_->stop.request_stop();
}

template <class Result>
bool Background<Result>::waitFor(std::chrono::microseconds time)
{
    if (!job_ || !job_->finished.try_acquire_for(time))
        return !job_;
    deliver();
    return true;
}

template <class Result>
void Background<Result>::wait()
{
    if (!job_)
        return;
    job_->finished.acquire();
    deliver();
}

/// The result may destroy this object or start other work.
template <class Result>
void Background<Result>::deliver()
{
    if (!job_)
        return;
    job_.reset();
    progressed_ = {};
    const auto done = std::exchange(done_, {});
    done(watcher_.future().takeResult());
}

} // namespace app
