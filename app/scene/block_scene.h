// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/variant.h"
#include "app/scene/scene_block_cache.h"
#include "app/scene/scene_clipping.h"

namespace app {

/// The lines of a document that is being edited, kept up to date, and what clipping leaves of them.
class BlockScene {
public:
    /// To be called after an edit: replaces the lines of the objects that changed. The objects in
    /// `hidden` have no lines, even if they are visible themselves; `tolerance`, in user units, is
    /// that of `flatten`. Ends the validity of a frame.
    void update(const Objects& objects, const ObjectRanges& hidden, double tolerance);

    const SceneLines& lines() const { return lines_; }

    /// The kept part of every line; see `SceneClipping`. The variant must not be an exhibit.
    /// Valid until the next call and the next update.
    SceneFrame clip(const ClipRegion& region, const Variant& variant);

private:
    SceneBlockCache cache_;
    SceneLines lines_;
    SceneClipping clipping_;
};

} // namespace app
