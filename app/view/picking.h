// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene.h"
#include "app/view/block_grid.h"

#include <optional>

namespace app {

/// Finds lines and objects by place, fast enough for hovering over millions of lines. Each block of
/// the scene gets a grid when it is asked for, and keeps it as long as the block is in the scene.
class Picking {
public:
    Picking(const EditedDocument& document, const Scene& scene) : document_(document), scene_(scene)
    {
    }

    /// Every line that comes within `radius` of the point, ascending.
    std::vector<std::size_t> near(const Point& point, double radius) const;

    /// The nearest of those (the uppermost of equally near ones) whose object may be picked.
    std::optional<std::size_t> nearest(const Point& point, double radius) const;

    /// The uppermost filled object that may be picked and whose area the point is in.
    std::optional<std::size_t> areaAt(const Point& point) const;

    enum class Box : std::uint8_t { Contains, Touches };
    /// The objects that a rectangle contains wholly or touches, of those that may be picked.
    ObjectRanges objectsIn(const clipping::Window& rectangle, Box box) const;

    /// Shown, and not on a locked layer.
    bool pickable(std::size_t object) const { return document_.now().editable(object); }

private:
    struct Block {
        Shared<SceneBlock> block; // it has an owner here: so no other one can get its address
        FloatBox around{};
        std::optional<BlockGrid> grid{};
    };
    void follow() const;

    const EditedDocument& document_;
    const Scene& scene_;
    mutable std::uint64_t revision_ = 0; // of the lines that blocks_ are of
    mutable std::vector<Block> blocks_;
};

} // namespace app
