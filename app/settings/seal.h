// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

#include <optional>

namespace app {

/// Prepends a checksum to `bytes`, for readers that trust their input (QMainWindow::restoreState
/// crashes on a single damaged byte).
QByteArray sealed(const QByteArray& bytes);

/// The bytes that sealed() was given; empty if a bit has changed or if they were never sealed.
std::optional<QByteArray> unsealed(const QByteArray& bytes);

} // namespace app
