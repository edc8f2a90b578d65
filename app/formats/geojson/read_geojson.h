// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"

namespace app::geojson {

constexpr qint64 mostBytes = 500'000'000; ///< of a file

/// Reads the lines, polygons and points of a GeoJSON file, or of a sequence of texts (RFC 8142, or
/// one on each line): x to the right, y up, a user unit for each unit of the numbers. The property
/// "layer" names the layer; "stroke", "fill" and so on are the look.
Result<Imported> read(QIODevice& in, const ReadOptions& options);

} // namespace app::geojson
