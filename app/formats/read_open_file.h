// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"

#include <QFileDevice>

namespace app {

/// Reads an open file. A read error in the middle of it is reported as an error, never as a shorter
/// drawing.
Result<Imported> readOpenFile(QFileDevice& file, const Format& format,
                              const ReadOptions& options = {});

/// Why this file cannot be opened, to follow "Cannot open NAME: ": it is a folder, or not there.
std::optional<QString> faultToOpen(const QString& path);

/// The format for a file name extension, in any case. A DWG drawing counts as DXF, whose reader says
/// how to convert it.
const Format* formatToRead(const QString& path);

} // namespace app
