// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

#include <optional>

class QIODevice;

namespace app {

bool isZipped(QIODevice& in); ///< whether it begins as gzip does

/// What is compressed in the rest of a device. Empty: it is damaged or incomplete, or larger than
/// `most` bytes.
std::optional<QByteArray> unzipped(QIODevice& in, std::size_t most);

/// The same bytes for the same text, without a name and a time.
QByteArray zipped(const QByteArray& text);

} // namespace app
