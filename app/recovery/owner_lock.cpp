// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recovery/owner_lock.h"

#include <QFile>

#include <thread>

#if defined(Q_OS_UNIX)
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#endif

namespace app {
namespace {

// QLockFile keeps its file locked, too, and the system ends that lock with the process.
bool isLockedBySomeone(const QString& path)
{
#if defined(Q_OS_UNIX)
    const int file = ::open(QFile::encodeName(path).constData(), O_RDWR | O_CLOEXEC);
    if (file < 0)
        return true;
    const bool locked = ::flock(file, LOCK_EX | LOCK_NB) != 0;
    ::close(file);
    return locked;
#else
    return !path.isEmpty();
#endif
}

// Another process may be about to take the lock over, and have written its file just now.
constexpr std::chrono::milliseconds timeToLock{20};

} // namespace

std::shared_ptr<QLockFile> newLock(const QString& file)
{
    auto lock = std::make_shared<QLockFile>(file);
    lock->setStaleLockTime(0);
    return lock->tryLock() ? lock : nullptr;
}

std::shared_ptr<QLockFile> oldLock(const QString& file)
{
    if (auto lock = newLock(file))
        return lock;
    if (isLockedBySomeone(file))
        return nullptr;
    std::this_thread::sleep_for(timeToLock);
    if (isLockedBySomeone(file))
        return nullptr;
    QFile::remove(file);
    return newLock(file);
}

} // namespace app
