// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/background.h"
#include "app/scene/scene.h"
#include "app/view/block_grid.h"

#include <optional>

namespace app {

/// Finds lines and objects by position, fast enough for hovering over millions of lines. Each block
/// of the scene gets a grid after its first query, and keeps it while the block is in the scene.
/// The grids of large drawings are laid on another thread; until then a query looks at every line.
class Picking {
public:
    Picking(const EditedDocument& document, const Scene& scene) : document_(document), scene_(scene)
    {
    }

    /// All lines within `radius` of the point, ascending.
    std::vector<std::size_t> near(const Point& point, double radius) const;

    /// The same within limits: in a crowd the radius is halved until it has few enough lines. If a
    /// tiny radius has too many, or too many lines must be looked at, some are found.
    std::vector<std::size_t> near(const Point& point, double radius, NearLimits limits) const;

    /// Of the lines whose objects are pickable the topmost that is as good as under the point (1/32
    /// of the radius); else the nearest within it, of equally near ones the topmost. So the lines
    /// below need not be looked at where they lie above each other by the hundred thousand.
    std::optional<std::size_t> nearest(const Point& point, double radius) const;

    /// The topmost pickable filled object whose area contains the point.
    std::optional<std::size_t> areaAt(const Point& point) const;

    enum class Box : std::uint8_t { Contains, Touches };
    /// The pickable objects that a rectangle contains entirely, or touches.
    ObjectRanges objectsIn(const clipping::Window& rectangle, Box box) const;

    /// Whether the object is shown, and no container around it is locked.
    bool pickable(std::size_t object) const { return document_.now().editable(object); }

private:
    struct Block {
        Shared<SceneBlock> block; // owned here, so that no other block gets its address
        FloatBox around{};
        std::optional<BlockGrid> grid{};
        bool isLaid = true; ///< false: it has one cell, until the grid is laid
    };
    void follow() const;
    void grid(Block& block) const;
    void layNext() const;
    bool find(const Point& point, double radius, NearLimits& limits,
              std::vector<std::size_t>& found) const;
    bool findIn(std::size_t block, const Point& point, double radius, NearLimits& limits,
                std::vector<std::size_t>& found) const;

    const EditedDocument& document_;
    const Scene& scene_;
    mutable std::uint64_t revision_ = 0; // revision of the lines that blocks_ belong to
    mutable std::vector<Block> blocks_;
    mutable Background<BlockGrid> laying_;
};

/// The colour of what is seen at a point: of the nearest line within `radius`, else of the area
/// there. Empty: nothing is there. Lines of locked layers count, too.
std::optional<Colour> colourAt(const Document& document, const Scene& scene, const Picking& picking,
                               const Point& point, double radius);

} // namespace app
