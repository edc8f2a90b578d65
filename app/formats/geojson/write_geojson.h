// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"

namespace app::geojson {

/// Writes a drawing as a feature collection, a feature on each line: areas as polygons, other paths
/// as lines, curves within the tolerance; y up. Returns nothing, or what went wrong.
std::optional<QString> write(const Document& document, QIODevice& out, const WriteOptions& options);

} // namespace app::geojson
