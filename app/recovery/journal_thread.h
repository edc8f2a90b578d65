// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace app {

class LogFile;

/// The thread that syncs a journal's log: at most `within` after the first append since the last
/// sync, however busy all other threads are.
class LogSync {
public:
    static constexpr std::chrono::milliseconds within{500};
    /// Called on that thread if a log may not be on the disk, with the reason.
    using Failed = std::function<void(const std::shared_ptr<LogFile>&, const QString& reason)>;

    explicit LogSync(Failed failed);
    ~LogSync(); ///< without a last sync: the files are about to be removed
    void appended(const std::shared_ptr<LogFile>& log);

private:
    void run(const std::stop_token& stop);

    const Failed failed_;
    std::mutex lock_;
    std::condition_variable_any changed_;
    std::vector<std::shared_ptr<LogFile>> logs_; ///< with bytes that may not be on the disk
    std::jthread thread_;                        ///< last: it ends before its data
};

/// A thread that does one job after the other.
class JobThread {
public:
    JobThread();
    ~JobThread(); ///< waits for the current job; the others are not done
    void post(std::function<void()> job);
    void finish(); ///< waits until all jobs are done

private:
    void run(const std::stop_token& stop);

    std::mutex lock_;
    std::condition_variable_any changed_;
    std::deque<std::function<void()>> jobs_;
    bool busy_ = false;
    std::jthread thread_;
};

} // namespace app
