// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object_ranges.h"
#include "app/document/objects.h"

namespace app {

/// The styles of these objects, each once, in the order of the objects. Fast for many objects:
/// 1,000,000 take some milliseconds.
std::vector<StyleIndex> stylesOf(const Objects& objects, const ObjectRanges& chosen);

/// The colours of all strokes and fills, the most used first; of equally used ones the first in the
/// drawing. Transparent colours are omitted. At most `most` colours.
std::vector<Colour> coloursInUse(const Objects& objects, std::size_t most);

} // namespace app
