// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFileDevice>
#include <QString>

#include <functional>
#include <optional>

// All output to files, devices and standard output goes through these functions.

namespace app {

/// Writes the content to `out`. Returns nothing, or a sentence that says what went wrong. It need
/// not check each write: the caller detects errors of `out` itself.
using Filling = std::function<std::optional<QString>(QIODevice& out)>;

/// Calls `write` with the open `file` and flushes it to the system. Returns nothing, or why this
/// failed. A closed pipe (`| head`) is no error: the remaining output is dropped.
std::optional<QString> fill(QFileDevice& file, const Filling& write);

/// Like fill(), for a file on a disk; returns once the data are on the disk.
std::optional<QString> fillToDisk(QFileDevice& file, const Filling& write);

/// Opens the file at `path` and calls `write` to fill it. Returns nothing, or why this failed. An
/// existing file is replaced only by a complete new file that is already on the disk, and not at
/// all if `write` reports an error. Devices and pipes are written to directly. Symbolic links are
/// followed; a link that leads only to itself is refused.
std::optional<QString> replaceFile(const QString& path, const Filling& write);

/// Checks that a file can have this name. Empty if so; otherwise a text that says what is wrong and
/// what to do, to follow "Cannot open NAME: ". File names must be UTF-8: Qt has lost the bytes of
/// any other name, so a file written under it would get a different name.
std::optional<QString> faultOfName(const QString& path);

} // namespace app
