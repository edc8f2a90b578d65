// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/block_scene.h"

#include <cassert>

namespace app {

void BlockScene::update(const Objects& objects, const ObjectRanges& hidden, double tolerance)
{
    SceneBlockCache next = cache_;
    if (!next.update(objects, hidden, tolerance))
        return;
    lines_ = SceneLines(next.blocks());
    cache_ = std::move(next);
}

SceneFrame BlockScene::clip(const ClipRegion& region, const Variant& variant)
{
    assert(!variant.misprint && clipping::functionsOf(*variant.algorithm, variant.form));
    return clipping_.clip(lines_, region,
                          clipping::functionsOf(*variant.algorithm, variant.form)->clipAll);
}

} // namespace app
