// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

#include <optional>

namespace app {

/// `bytes` with a check sum before them, for what is read by code that trusts it
/// (QMainWindow::restoreState crashes on one damaged byte).
QByteArray sealed(const QByteArray& bytes);

/// What was sealed; nothing if a bit of it has changed, or if it never was.
std::optional<QByteArray> unsealed(const QByteArray& bytes);

} // namespace app
