// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/objects.h"
#include "app/scene/scene_block.h"

namespace app {

/// The scene blocks of some objects, together with their sources. An update rebuilds only the scene
/// blocks whose object block or hidden objects changed: O(blocks + segments of the changed blocks).
class SceneBlockCache {
public:
    /// Objects in `hidden` are not shown, even if visible themselves. Returns whether anything
    /// changed.
    bool update(const Objects& objects, const ObjectRanges& hidden, double tolerance);

    std::vector<Shared<SceneBlock>> blocks() const; ///< in order

private:
    /// One object block. Owning it here ensures that no other block gets its address.
    struct Source {
        Shared<ObjectBlock> objects;
        std::vector<ObjectRange> hidden; ///< numbered within the block
        std::vector<Shared<SceneBlock>> blocks;
    };
    void take(std::span<const Shared<ObjectBlock>> blocks);

    std::vector<Source> sources_;
    double tolerance_ = 0;
};

} // namespace app
