// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"

#include <cstdint>
#include <span>
#include <vector>

namespace app {

/// Finds the segments of a scene block by place: a uniform grid over them.
class BlockGrid {
public:
    /// At most SceneBlock::mostSegments, which are needed again to ask it.
    explicit BlockGrid(std::span<const clipping::Segment> segments);

    /// Appends those that come within `radius` of the point, ascending, each number plus `first`.
    void findNear(std::span<const clipping::Segment> segments, const Point& point, double radius,
                  std::size_t first, std::vector<std::size_t>& found) const;

private:
    struct Cells {
        std::size_t x0, y0, x1, y1;
    }; // inclusive
    Cells cellsOf(const Point& min, const Point& max) const;
    void lay(std::span<const clipping::Segment> segments);
    template <class Visit>
    void visit(const clipping::Segment& segment, const Visit& cell) const;

    Point origin_{};
    Point cell_{1, 1};
    std::size_t columns_ = 1, rows_ = 1;
    std::vector<std::uint32_t> start_;    // of cell i: [start_[i], start_[i + 1]) of segments_
    std::vector<std::uint16_t> segments_; // a block has no more
};

/// The distance from a point to a segment.
double distance(const Point& point, const clipping::Segment& segment);

} // namespace app
