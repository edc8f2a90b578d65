// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recovery/journal_thread.h"

#include "app/recovery/log_file.h"

#include <algorithm>
#include <utility>

namespace app {

LogSync::LogSync(Failed failed)
    : failed_(std::move(failed)), thread_([this](const std::stop_token& stop) { run(stop); })
{
}

LogSync::~LogSync() = default;

void LogSync::appended(const std::shared_ptr<LogFile>& log)
{
    const std::lock_guard guard(lock_);
    if (std::ranges::find(logs_, log) != logs_.end())
        return;
    logs_.push_back(log);
    changed_.notify_one();
}

void LogSync::run(const std::stop_token& stop)
{
    std::unique_lock guard(lock_);
    while (changed_.wait(guard, stop, [this] { return !logs_.empty(); })) {
        changed_.wait_for(guard, stop, within, [] { return false; });
        if (stop.stop_requested())
            return;
        const auto logs = std::exchange(logs_, {});
        guard.unlock();
        for (const auto& log : logs)
            if (const auto wrong = log->sync())
                failed_(log, *wrong);
        guard.lock();
    }
}

JobThread::JobThread() : thread_([this](const std::stop_token& stop) { run(stop); }) {}

JobThread::~JobThread() = default;

void JobThread::post(std::function<void()> job)
{
    const std::lock_guard guard(lock_);
    jobs_.push_back(std::move(job));
    changed_.notify_all();
}

void JobThread::finish()
{
    std::unique_lock guard(lock_);
    changed_.wait(guard, [this] { return jobs_.empty() && !busy_; });
}

void JobThread::run(const std::stop_token& stop)
{
    std::unique_lock guard(lock_);
    while (changed_.wait(guard, stop, [this] { return !jobs_.empty(); })) {
        if (stop.stop_requested())
            return;
        const auto job = std::move(jobs_.front());
        jobs_.pop_front();
        busy_ = true;
        guard.unlock();
        job();
        guard.lock();
        busy_ = false;
        changed_.notify_all();
    }
}

} // namespace app
