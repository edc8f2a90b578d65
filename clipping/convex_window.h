// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/point.h"

#include <memory>
#include <ranges>

namespace CLEARCUT_API clipping {

/// A closed convex polygon that is prepared once, exactly, and then clips any number of times
/// (clip.h). Cheap to copy; may be used by several threads. ConvexPolygon (geometry.h) defines
/// which lists of corners are polygons, but here clockwise ones are turned round. Edge i always
/// runs between the corners i and i + 1 that were given.
class ConvexWindow {
public:
    ConvexWindow() noexcept = default; ///< contains nothing

    /// Takes O(corners).
    explicit ConvexWindow(std::span<const glm::dvec2> corners);

    /// Whether the corners are those of a convex polygon. If not, it contains nothing.
    explicit operator bool() const noexcept { return data_ != nullptr; }

    /// Why it is not a polygon, in one sentence; empty if it is one.
    const char* whyNot() const noexcept { return whyNot_; }

    struct Data;
    const Data* data() const noexcept { return data_.get(); } ///< for the library

private:
    std::shared_ptr<const Data> data_;
    const char* whyNot_ = "A polygon needs at least one corner.";
};

inline ConvexWindow ConvexPolygon::from(std::span<const glm::dvec2> given)
{
    return ConvexWindow(given);
}
inline ConvexWindow ConvexPolygon::from(std::initializer_list<glm::dvec2> given)
{
    return ConvexWindow(std::span(given.begin(), given.size()));
}
/// The same for corners of any type with the coordinates of a point (point.h).
template <class Points>
ConvexWindow ConvexPolygon::from(const Points& given)
{
    std::vector<glm::dvec2> points;
    for (const auto& corner : given)
        points.emplace_back(pointOf(corner));
    return ConvexWindow(points);
}

} // namespace clipping
