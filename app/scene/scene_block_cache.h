// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/objects.h"
#include "app/scene/scene_block.h"

namespace app {

/// The scene blocks of some objects, and what they were made of. An update makes only those whose
/// object block is another one, or whose objects are hidden otherwise: it costs O(blocks) and the
/// segments of what has changed.
class SceneBlockCache {
public:
    /// `hidden` are not shown, whatever they say themselves. Whether anything has changed.
    bool update(const Objects& objects, const ObjectRanges& hidden, double tolerance);

    std::vector<Shared<SceneBlock>> blocks() const; ///< in order

private:
    /// One object block. It has an owner here: so no other block can get its address.
    struct Source {
        Shared<ObjectBlock> objects;
        std::vector<ObjectRange> hidden; ///< numbered in the block
        std::vector<Shared<SceneBlock>> blocks;
    };
    void take(std::span<const Shared<ObjectBlock>> blocks);

    std::vector<Source> sources_;
    double tolerance_ = 0;
};

} // namespace app
