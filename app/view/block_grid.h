// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace app {

/// How much a search may find, and how many segments it may look at.
struct NearLimits {
    std::size_t found = std::numeric_limits<std::size_t>::max();
    std::size_t looks = std::numeric_limits<std::size_t>::max();
};

/// Finds the segments of a scene block by position, with a uniform grid.
class BlockGrid {
public:
    /// At most SceneBlock::mostSegments segments. findNear() needs the same segments again.
    explicit BlockGrid(std::span<const clipping::Segment> segments);
    /// One cell for so many segments, made in no time: every search looks at all of them.
    static BlockGrid ofOneCell(std::size_t segments);

    /// Appends the numbers, plus `first`, of the segments within `radius` of the point, ascending.
    /// Stops after looking at `limits.looks` segments, which it counts down. False: it stopped
    /// because `found` would have more than `limits.found` numbers.
    bool findNear(std::span<const clipping::Segment> segments, const Point& point, double radius,
                  std::size_t first, std::vector<std::size_t>& found, NearLimits& limits) const;

private:
    BlockGrid() = default;

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
    std::vector<std::uint32_t> start_;    // cell i has [start_[i], start_[i + 1]) of segments_
    std::vector<std::uint16_t> segments_; // 16 bits suffice for the segments of a block
};

/// The distance from a point to a segment.
double distance(const Point& point, const clipping::Segment& segment);

} // namespace app
