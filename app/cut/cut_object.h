// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object.h"
#include "app/scene/region.h"

namespace app {

/// What a cut leaves of an object.
struct CutObject {
    bool whole = false;         ///< all of it, unchanged
    std::vector<Object> left{}; ///< else what is left, bottom to top
    std::size_t opened = 0;     ///< closed subpaths that are open now
};

/// Cuts an object by what is kept of its lines. `chords` are those of
/// `flatten(object.path, tolerance)`; `pieces` come in their order, and their sources count from
/// `first`. A cut object has no inside to fill any more: one that was only filled is outlined.
CutObject cutObject(const Object& object, double tolerance, std::span<const Chord> chords,
                    std::span<const clipping::Clipped> pieces, std::size_t first,
                    const ClipRegion& region);

} // namespace app
