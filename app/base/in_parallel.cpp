// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/in_parallel.h"

#include <QThreadPool>

#include <algorithm>
#include <atomic>
#include <exception>
#include <latch>
#include <memory>
#include <mutex>
#include <new>

namespace app {
namespace {

/// Shared by the threads, of which some may begin when everything is done, and `work` is gone.
class Items {
public:
    using Work = std::function<void(std::size_t, std::size_t)>;

    Items(const Work& work, std::size_t count)
        : work_(work), count_(count), left_(std::ptrdiff_t(count))
    {
    }

    /// Works on items that no other thread has begun.
    void follow(std::size_t worker)
    {
        for (std::size_t item = next_++; item < count_; item = next_++) {
            try {
                if (!failed_)
                    work_(item, worker);
            } catch (...) {
                const std::scoped_lock one(lock_);
                error_ = error_ ? error_ : std::current_exception();
                failed_ = true;
            }
            left_.count_down();
        }
    }
    void wait()
    {
        left_.wait();
        if (error_)
            std::rethrow_exception(error_);
    }

private:
    const Work& work_;
    const std::size_t count_;
    std::atomic<std::size_t> next_ = 0;
    std::latch left_;
    std::atomic<bool> failed_ = false;
    std::mutex lock_;
    std::exception_ptr error_; ///< guarded by lock_ until all items are done
};

} // namespace

std::size_t workersOf(const QThreadPool& pool)
{
    return std::size_t(std::max(1, pool.maxThreadCount()));
}

void inParallel(QThreadPool& pool, std::size_t workers, std::size_t items,
                const std::function<void(std::size_t item, std::size_t worker)>& work)
{
    const auto shared = std::make_shared<Items>(work, items);
    try {
        for (std::size_t worker = 1; worker < std::min(workers, items); ++worker)
            pool.start([shared, worker] { shared->follow(worker); });
    } catch (const std::bad_alloc&) { // those that were started use what is here
    }
    shared->follow(0);
    shared->wait();
}

} // namespace app
