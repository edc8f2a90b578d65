// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLockFile>
#include <QString>

#include <memory>

// Locks that name the process that owns something, and are taken over when it has ended.

namespace app {

/// Null while the process that the file names is running.
std::shared_ptr<QLockFile> newLock(const QString& file);
/// The same for a lock that its owner must have had for a while. Damaged contents, which name
/// another process or none, count only while a process has the file locked.
std::shared_ptr<QLockFile> oldLock(const QString& file);

} // namespace app
