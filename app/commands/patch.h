// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/memory.h"
#include "app/commands/undo_command.h"
#include "app/document/drawing.h"
#include "app/document/object_ranges.h"

#include <functional>

namespace app {

/// What undo commands do to the shapes: `count` shapes from `first` on are exchanged for `shapes`.
struct Patch {
    std::size_t first = 0, count = 0;
    std::vector<Shape> shapes;
};

/// Patches that do not overlap, ascending, all numbered as the drawing is before any is applied.
using Patches = std::vector<Patch>;

inline std::size_t heapBytes(const Patch& patch) { return heapBytes(patch.shapes); }

/// Applies them; what comes back, given to `revert`, undoes that, and the other way round.
void apply(Drawing& drawing, Patches& patches);
void revert(Drawing& drawing, Patches& patches);

/// Whether both exchange as many shapes for as many in the same places; many scattered ones are one
/// place. If the second was applied right after the first, reverting the first alone undoes both.
bool samePlaces(const Patches& first, const Patches& second);

/// One patch for each range of `shapes`, with a copy of each after `change`; a shape
/// for which it says false is left out. Many short ranges become one, with what is between them as
/// it is, because each patch moves all the shapes above it.
Patches patchesOf(const Sheet& sheet, const ObjectRanges& shapes,
                  const std::function<bool(Shape&)>& change);

} // namespace app
