// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object.h"
#include "app/formats/svg/convex_region.h"

#include <vector>

namespace app::svg {

/// An object while its outline is still being processed, before it is packed.
struct Drawn {
    std::vector<Subpath> paths;
    Style style;
    Particulars particulars{};
    bool hidden = false;
};

} // namespace app::svg

namespace app::svg {

/// The objects that a clip path leaves of an object: the object itself if it is entirely inside;
/// otherwise the clipped area, filled as before, and above it the stroke as open runs, with curves
/// split and dashes continued. The first object keeps the
/// particulars, apart from the recipe. Empty if the object is
/// entirely outside.
struct ClippedObject {
    std::vector<Drawn> objects;
    bool cut = false;     ///< whether it is neither entirely inside nor entirely outside
    std::size_t work = 0; ///< chords times sides, for the limit mostClipWork
    /// Whether its stroke, which is cut at its centre line, visibly differs from one that is cut
    /// along the area's sides.
    bool strokeDiffers = false;
};

/// `tolerance` is the flattening tolerance in user units. An empty optional for paths with so many
/// curves that flattening them could need too much memory.
std::optional<ClippedObject> clipObject(const Drawn& drawn, const ConvexRegion& region,
                                        double tolerance);

} // namespace app::svg
