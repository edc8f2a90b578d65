// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

#include <optional>

// Values from the settings file, treated as untrusted input.

namespace app {

/// A whole number from `least` to `most`; `usual` if the file has no such number.
int rememberedNumber(const QString& key, int least, int most, int usual);

/// A finite number from `least` to `most`; `usual` if the file has no such number.
double rememberedNumber(const QString& key, double least, double most, double usual);

/// The absolute path of a folder that exists; `usual` if the file has no such path.
QString rememberedFolder(const QString& key, const QString& usual);

/// Whether a text can be the path of a file: absolute, printable and not too long.
bool isUsablePath(const QString& path);

/// Prepends a checksum to `bytes`, for readers that trust their input (QMainWindow::restoreState
/// crashes on a single damaged byte).
QByteArray sealed(const QByteArray& bytes);

/// The bytes that sealed() was given; empty if a bit has changed or if they were never sealed.
std::optional<QByteArray> unsealed(const QByteArray& bytes);

} // namespace app
