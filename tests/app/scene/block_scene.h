// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/variant.h"
#include "app/scene/scene_block_cache.h"
#include "app/scene/scene_clipping.h"

// Lines that are clipped as for a frame.

/// Clips the lines of scenes; a frame is valid until the next one.
class FrameClipping {
public:
    app::SceneFrame clip(const app::SceneLines& lines, const app::ClipRegion& region,
                         const app::Variant& variant)
    {
        return clipping_.clip(lines, region,
                              clipping::functionsOf(*variant.algorithm, variant.form)->clipAll);
    }

private:
    app::SceneClipping clipping_;
};

/// Of how many lines something is kept.
inline std::size_t visibleIn(const app::SceneLines& lines, const app::ClipRegion& region,
                             const app::Variant& variant)
{
    return FrameClipping().clip(lines, region, variant).visible;
}

/// The lines of objects, kept up to date, and the result of clipping them.
class BlockScene {
public:
    void update(const app::Objects& objects, const app::ObjectRanges& hidden, double tolerance)
    {
        if (blocks_.update(objects, hidden, tolerance))
            lines_ = app::SceneLines(blocks_.blocks());
    }
    const app::SceneLines& lines() const { return lines_; }
    app::SceneFrame clip(const app::ClipRegion& region, const app::Variant& variant)
    {
        return clipping_.clip(lines_, region, variant);
    }

private:
    app::SceneBlockCache blocks_;
    app::SceneLines lines_;
    FrameClipping clipping_;
};
