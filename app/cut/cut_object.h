// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cut/area_cut.h"
#include "app/cut/curved_border.h"
#include "app/cut/cut.h"

namespace app {

/// What remains of an object after a cut.
struct CutObject {
    bool whole = false;         ///< the whole object, unchanged
    std::vector<Object> left{}; ///< otherwise the remaining parts, bottom to top
    bool parted = false;        ///< `left` begins with the area, and its lines follow
    std::size_t opened = 0;     ///< closed subpaths that became open
    std::size_t dropped = 0;    ///< pieces shorter than the least length
    bool slanted = false;       ///< a wide stroke ends at a slanted edge (`CutCounts`)
};

/// Cuts an object, given the kept pieces of its lines, and the area that is left if it is filled.
/// `chords` are those of `flatten(object.path, options.tolerance)`. `pieces` are in the order of
/// the chords, and their sources count from `first`. Where they are cut at the curves of `border`,
/// its true curves count.
CutObject cutObject(const Object& object, const CutOptions& options, std::span<const Chord> chords,
                    std::span<const clipping::Clipped> pieces, std::size_t first,
                    const std::optional<AreaLeft>& area, const CurvedBorder& border = {});

} // namespace app
