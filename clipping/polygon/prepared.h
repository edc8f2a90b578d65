// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/numbers.h"

#include <optional>

namespace clipping {

/// A convex polygon prepared for the algorithms; tests that depend on the polygon alone run here,
/// once. It is strictly convex and counter-clockwise: no repeated corner, none on the line between
/// two others. The first edge is the first upward one, so that the directions of the edges increase
/// from 0 to 360 degrees.
struct PreparedPolygon {
    std::vector<glm::dvec2> corners;
    std::vector<glm::dvec2>
        edges; ///< edge i: from corner i to the next (not exact; for `ordinary`)
    std::vector<std::uint32_t> numbers; ///< 1 + the index that edge i has in the input
    Window box;                         ///< the bounding box
    bool flat;                          ///< one or two corners: a point, or a segment
    bool ordinary;                      ///< in the sense of frame.h
    /// Whether a new end has an edge number even where rounding brings it back to the input's end.
    bool namesEveryCut = false;
};

/// Nothing for a polygon that contains nothing: one without corners, with a non-finite number,
/// clockwise, not convex, or going round more than once. The decision is exact.
std::optional<PreparedPolygon> prepared(const ConvexPolygon& polygon);

/// The same, with the corners in the order given or in the opposite one. Each edge has the number
/// of the edge between the same two corners as given.
enum class Order : std::uint8_t { Given, Reversed };
std::optional<PreparedPolygon> prepared(std::span<const glm::dvec2> corners, Order order);

/// A prepared polygon with coordinates of type T.
template <class T>
class PolygonIn {
public:
    explicit PolygonIn(const PreparedPolygon& polygon) : polygon_(&polygon) {}

    std::size_t size() const { return polygon_->corners.size(); }
    std::size_t after(std::size_t i) const { return i + 1 == size() ? 0 : i + 1; }
    glm::vec<2, T> corner(std::size_t i) const { return pointIn<T>(polygon_->corners[i]); }
    glm::vec<2, T> edge(std::size_t i) const
    {
        if constexpr (std::is_same_v<T, double> || std::is_same_v<T, Counted<double>>)
            return pointIn<T>(polygon_->edges[i]);
        else {
            const auto from = corner(i), to = corner(after(i));
            return {to.x - from.x, to.y - from.y};
        }
    }
    std::uint32_t number(std::size_t i) const { return polygon_->numbers[i]; }
    BasicWindow<T> box() const { return windowIn<T>(polygon_->box); }

private:
    const PreparedPolygon* polygon_;
};

} // namespace clipping
