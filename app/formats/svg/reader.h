// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"

namespace app::svg {

/// Reads an SVG drawing as a document: transforms are applied, styles computed, <use> elements
/// expanded, and hidden objects stay hidden. An error sentence begins with the line ("line 212 is
/// not complete ..."). Time and memory are bounded by limits.h, whatever the file contains.
Result<Imported> read(QIODevice& in);
Result<Imported> read(QIODevice& in, const ReadOptions& options);

} // namespace app::svg
