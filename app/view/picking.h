// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object_ranges.h"
#include "app/document/scene.h"

#include <optional>

namespace app {

/// Finds segments by place, fast enough for hovering over a million of them: a uniform grid, made
/// anew when it is asked for the first time after the drawing changed.
class Picking : public QObject {
    Q_OBJECT

public:
    Picking(const EditedDocument& document, const Scene& scene, QObject* parent = nullptr);

    /// Every segment that comes within `radius` of the point, ascending.
    std::vector<std::size_t> near(const Point& point, double radius) const;

    /// The nearest of those (the uppermost of equally near ones) whose shape may be picked.
    std::optional<std::size_t> nearest(const Point& point, double radius) const;

    /// The uppermost filled shape that may be picked and whose area the point is in.
    std::optional<std::size_t> areaAt(const Point& point) const;

    enum class Box : std::uint8_t { Contains, Touches };
    /// The shapes that a rectangle contains wholly or touches, of those that may be picked.
    ObjectRanges shapesIn(const clipping::Window& rectangle, Box box) const;

    /// Shown, and not on a locked layer.
    bool pickable(std::size_t shape) const;

private:
    struct Cells {
        std::size_t x0, y0, x1, y1;
    }; // inclusive
    Cells cellsOf(const Point& min, const Point& max) const;
    void build() const;
    template <class Visit>
    void visit(const clipping::Segment& segment, Visit cell) const;

    const EditedDocument& document_;
    const Scene& scene_;
    mutable bool outdated_ = true;
    mutable Point origin_{};
    mutable Point cell_{1, 1};
    mutable std::size_t columns_ = 1, rows_ = 1;
    mutable std::vector<std::uint32_t> start_, segments_; // of cell i: [start_[i], start_[i + 1])
};

/// The distance from a point to a segment.
double distance(const Point& point, const clipping::Segment& segment);

} // namespace app
