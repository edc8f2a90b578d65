// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cut/area_cut.h"
#include "app/document/object.h"
#include "app/scene/region.h"

namespace app {

/// What remains of an object after a cut.
struct CutObject {
    bool whole = false;         ///< the whole object, unchanged
    std::vector<Object> left{}; ///< otherwise the remaining parts, bottom to top
    std::size_t opened = 0;     ///< closed subpaths that became open
};

/// Cuts an object, given the kept pieces of its lines, and the area that is left if it is filled.
/// A filled object with a stroke becomes two: the area, and above it the lines. `chords` are those
/// of `flatten(object.path, tolerance)`. `pieces` are in the order of the chords, and their sources
/// count from `first`.
CutObject cutObject(const Object& object, double tolerance, std::span<const Chord> chords,
                    std::span<const clipping::Clipped> pieces, std::size_t first,
                    const ClipRegion& region, const std::optional<AreaLeft>& area);

} // namespace app
