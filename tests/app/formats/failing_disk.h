// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>
#include <vector>

// A disk that fails when a test says so. A function that a program defines goes before the one of
// the C library, also for Qt; so this header is for one source file a program.

namespace disk {

enum class Step { None, Read, Write, Sync, Rename };

struct State {
    Step fails = Step::None;
    std::size_t room = 0; ///< Step::Read, Step::Write: so many bytes are taken before
    int failures = 0;     ///< so often it did
};

inline State& state()
{
    static State all;
    return all;
}

inline bool isFile(int file)
{
    struct stat status {};
    return ::fstat(file, &status) == 0 && S_ISREG(status.st_mode);
}

inline bool fails(Step step)
{
    if (state().fails != step)
        return false;
    ++state().failures;
    errno = step == Step::Write ? ENOSPC : EIO;
    return true;
}

/// While it lives, this step fails for every file.
class Failing {
public:
    explicit Failing(Step step, std::size_t room = 0) { state() = {step, room, 0}; }
    ~Failing() { state() = {}; }
    Q_DISABLE_COPY_MOVE(Failing)
    int failures() const { return state().failures; }
};

/// While it lives, no file grows beyond so many bytes: a full disk that the kernel makes.
class Limit {
public:
    explicit Limit(std::size_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN))
    {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit now{bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &now);
    }
    ~Limit()
    {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    Q_DISABLE_COPY_MOVE(Limit)

private:
    rlimit before_{};
    void (*handler_)(int);
};

/// At which bytes of a file of `size` the disk is full: each of a small one; of a large one the
/// first, the last, those about the blocks that Qt writes (16 KiB), and some between.
inline std::vector<std::size_t> placesIn(std::size_t size)
{
    constexpr std::size_t small = 1500, ends = 4, block = 16384, between = 5;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < size; ++i)
        if (size <= small || i < ends || size - i <= ends || (i + 1) % block < 3
            || i % (size / between) == 0)
            places.push_back(i);
    return places;
}

} // namespace disk

extern "C" {

ssize_t write(int file, const void* bytes, std::size_t size)
{
    auto& [step, room, failures] = disk::state();
    if (step == disk::Step::Write && disk::isFile(file)) {
        if (size > 0 && room == 0) {
            disk::fails(step);
            return -1;
        }
        size = std::min(size, room);
        room -= size;
    }
    return ::syscall(SYS_write, file, bytes, size);
}

ssize_t writev(int file, const iovec* parts, int count)
{
    ssize_t all = 0;
    for (int i = 0; i < count; ++i) {
        const ssize_t written = write(file, parts[i].iov_base, parts[i].iov_len);
        if (written < 0)
            return all > 0 ? all : written;
        all += written;
        if (std::size_t(written) < parts[i].iov_len)
            break;
    }
    return all;
}

ssize_t read(int file, void* bytes, std::size_t size)
{
    auto& [step, room, failures] = disk::state();
    if (step == disk::Step::Read && disk::isFile(file)) {
        if (size > 0 && room == 0) {
            disk::fails(step);
            return -1;
        }
        size = std::min(size, room);
        room -= size;
    }
    return ::syscall(SYS_read, file, bytes, size);
}

int fsync(int file)
{
    return disk::isFile(file) && disk::fails(disk::Step::Sync) ? -1
                                                               : int(::syscall(SYS_fsync, file));
}

int fdatasync(int file)
{
    return disk::isFile(file) && disk::fails(disk::Step::Sync)
               ? -1
               : int(::syscall(SYS_fdatasync, file));
}

int rename(const char* from, const char* to) noexcept
{
    return disk::fails(disk::Step::Rename)
               ? -1
               : int(::syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0));
}

int linkat(int fromFolder, const char* from, int toFolder, const char* to, int flags) noexcept
{
    return disk::fails(disk::Step::Rename)
               ? -1
               : int(::syscall(SYS_linkat, fromFolder, from, toFolder, to, flags));
}
}
