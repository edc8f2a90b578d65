// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIODevice>

#include <functional>
#include <optional>

namespace app {

/// Opens the file at `path` and has `write` fill it; nothing, or why it could not be done. An
/// existing file is replaced only by a whole new one, and not at all if `write` says that something
/// went wrong; a device or a pipe is written to.
std::optional<QString>
replaceFile(const QString& path,
            const std::function<std::optional<QString>(QIODevice& out)>& write);

} // namespace app
