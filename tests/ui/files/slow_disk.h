// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSemaphore>

#include <atomic>
#include <cerrno>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <thread>
#include <unistd.h>

// A disk on which a file of another thread is written when a test lets it. A function that a
// program defines goes before the one of the C library, also for Qt; so this header is for one
// source file a program.

namespace disk {

/// From its construction on, the next write of another thread waits.
class Slow {
public:
    Slow() { current() = this; }
    ~Slow()
    {
        finish();
        current() = nullptr;
    }
    Q_DISABLE_COPY_MOVE(Slow)

    bool begun() { return begun_; }
    void finish() { write_.release(); }
    /// Every write fails from then on.
    void fail()
    {
        full_ = true;
        finish();
    }

    static std::atomic<Slow*>& current()
    {
        static std::atomic<Slow*> slow = nullptr;
        return slow;
    }
    bool takes(int file)
    {
        struct stat status {};
        if (std::this_thread::get_id() == tester_ || ::fstat(file, &status) != 0
            || !S_ISREG(status.st_mode))
            return true;
        if (!begun_.exchange(true))
            write_.acquire();
        return !full_;
    }

private:
    const std::thread::id tester_ = std::this_thread::get_id();
    std::atomic<bool> begun_ = false, full_ = false;
    QSemaphore write_;
};

} // namespace disk

extern "C" ssize_t write(int file, const void* bytes, std::size_t size)
{
    if (disk::Slow* slow = disk::Slow::current(); slow && !slow->takes(file)) {
        errno = ENOSPC;
        return -1;
    }
    return ::syscall(SYS_write, file, bytes, size);
}
