// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/svg/convex_region.h"
#include "app/formats/svg/drawn.h"

namespace app::svg {

/// What a clip path leaves of an object, as real objects: the object itself where it is wholly
/// inside; otherwise the clipped area, filled as before, and above it the stroke as open runs,
/// whose curves are split and whose dashes go on. The first of them has the particulars. Nothing
/// where it is wholly outside.
struct ClippedObject {
    std::vector<Drawn> objects;
    bool cut = false;     ///< neither wholly inside nor wholly outside
    std::size_t work = 0; ///< chords times sides, for the limit
};

/// `tolerance` is for curves, in user units. Nothing at all (an empty optional) for paths of so
/// many curves that flattening them could take too much memory.
std::optional<ClippedObject> clipObject(const Drawn& drawn, const ConvexRegion& region,
                                        double tolerance);

} // namespace app::svg
