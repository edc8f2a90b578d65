// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/variant.h"
#include "app/scene/scene_block_cache.h"
#include "app/scene/scene_clipping.h"

namespace app {

/// The lines of the edited document, kept up to date, and the result of clipping them.
class BlockScene {
public:
    /// Call after each edit: replaces the lines of the objects that changed. Objects in `hidden`
    /// have no lines, even if they are visible themselves. `tolerance` is the flattening tolerance
    /// in user units. Invalidates all frames. If memory runs out, nothing has changed.
    void update(const Objects& objects, const ObjectRanges& hidden, double tolerance);

    const SceneLines& lines() const { return lines_; }

    /// Clips every line; see `SceneClipping`. The variant must not be a known misprint. The frame
    /// is valid until the next call and the next update.
    SceneFrame clip(const ClipRegion& region, const Variant& variant);

private:
    SceneBlockCache cache_;
    SceneLines lines_;
    SceneClipping clipping_;
};

} // namespace app
