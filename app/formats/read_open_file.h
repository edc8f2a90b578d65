// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"

#include <QFileDevice>

namespace app {

/// Reads what is open. A disk or a pipe that fails half-way is a sentence, not a shorter drawing.
Result<Imported> readOpenFile(QFileDevice& file, const Format& format);

/// By the ending of its name, any case. A compressed SVG drawing (.svgz) counts as SVG: the reader
/// says what to do with it.
const Format* formatToRead(const QString& path);

} // namespace app
