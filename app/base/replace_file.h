// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFileDevice>

#include <functional>
#include <optional>

// The one place where bytes reach a file, a device or standard output.

namespace app {

/// Fills `out`; nothing, or the sentence that says what went wrong. It need not look at every
/// write: what `out` refused is known without.
using Filling = std::function<std::optional<QString>(QIODevice& out)>;

/// Has `write` fill the open `file`, and hands all of it to the system; nothing, or why it could
/// not be done. A pipe whose reader has gone (`| head`) is no error: the rest is dropped.
std::optional<QString> fill(QFileDevice& file, const Filling& write);

/// The same for a file on a disk, which has reached it then.
std::optional<QString> fillToDisk(QFileDevice& file, const Filling& write);

/// Opens the file at `path` and has `write` fill it; nothing, or why it could not be done. An
/// existing file is replaced only by a whole new one that has reached the disk, and not at all if
/// `write` says that something went wrong; a device or a pipe is written to. A link to a file is
/// followed, and refused if it leads nowhere but to itself.
std::optional<QString> replaceFile(const QString& path, const Filling& write);

} // namespace app
