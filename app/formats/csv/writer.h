// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"

namespace app::csv {

/// Writes a header and one row for each line: x1,y1,x2,y2,layer,colour,width and, if
/// `options.sources` is given, source. Curves are written as their chords. An object with only a
/// fill is written as its outline in the fill colour.
std::optional<QString> write(const Document& document, QIODevice& out, const WriteOptions& options);

} // namespace app::csv
