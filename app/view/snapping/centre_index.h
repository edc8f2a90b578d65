// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/edited_document.h"
#include "app/scene/scene.h"

#include <vector>

namespace app {

/// Finds the centres of shown rectangles, ellipses, stars and circular arcs by position. Each block
/// of objects is read once, and again only after it has changed.
class CentreIndex {
public:
    CentreIndex(const EditedDocument& document, const Scene& scene)
        : document_(document), scene_(scene)
    {
    }

    /// The centres within `radius` of the point, at most 1,000; not those of the objects
    /// `without`.
    std::vector<Point> near(const Point& point, double radius, const ObjectRanges& without) const;

private:
    struct Centre {
        Point at;
        std::uint32_t object; // in the block
    };
    struct Block {
        Shared<ObjectBlock> block;   // owned here, so that no other block gets its address
        std::vector<Centre> centres; // by x
    };
    void follow() const;
    static std::vector<Centre> centresOf(const ObjectBlock& block);

    const EditedDocument& document_;
    const Scene& scene_;
    mutable std::vector<Block> blocks_;
};

} // namespace app
