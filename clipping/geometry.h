// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/abi.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <type_traits>
#include <vector>

namespace CLEARCUT_API clipping {

/// A directed segment in N dimensions, in the same unit as the window. `a == b` is legal and means
/// a single point.
template <class T, glm::length_t N = 2>
struct BasicSegment {
    static constexpr glm::length_t dimensions = N; ///< number of coordinates of a point
    glm::vec<N, T> a;                              ///< the start
    glm::vec<N, T> b;                              ///< the end
    /// Whether both ends are equal; -0 equals 0, NaN equals nothing.
    friend constexpr bool operator==(const BasicSegment&, const BasicSegment&) = default;
};

/// A closed window: its edges belong to it. `min == max` is legal; `min > max` contains nothing.
template <class T, glm::length_t N = 2>
struct BasicWindow {
    glm::vec<N, T> min; ///< the smallest coordinate on each axis
    glm::vec<N, T> max; ///< the largest coordinate on each axis
    /// Whether all edges are equal; -0 equals 0, NaN equals nothing.
    friend constexpr bool operator==(const BasicWindow&, const BasicWindow&) = default;
};

using Segment = BasicSegment<double>;
using Window = BasicWindow<double>;
using Segment3 = BasicSegment<double, 3>;
using Window3 = BasicWindow<double, 3>;

/// The infinite line through two points, directed from a to b. If `a == b`, nothing is
/// visible.
template <class T>
struct BasicLine {
    glm::vec<2, T> a; ///< a point of the line
    glm::vec<2, T> b; ///< another point, further along its direction
};
/// The ray that starts at a and passes through b. If `a == b`, it has no direction and
/// nothing is visible.
template <class T>
struct BasicRay {
    glm::vec<2, T> a; ///< the start
    glm::vec<2, T> b; ///< another point of the ray
};
using Line = BasicLine<double>;
using Ray = BasicRay<double>;

class ConvexWindow;

/// A closed convex window: its corners, counter-clockwise if y points up. Edge i runs from corner i
/// to the next one, the last edge to corner 0. Corners may be repeated, or lie on the line between
/// two others. If all corners are collinear, the polygon is the segment between the outermost two;
/// one corner is a point. A polygon contains nothing if it has no corners, is clockwise, turns
/// right at a corner, goes round more than once, or has a number that is not finite.
struct CLEARCUT_HOLDS_CONTAINERS ConvexPolygon {
    std::vector<glm::dvec2> corners; ///< in counter-clockwise order

    /// The polygon of these corners, prepared for clipping many times (convex_window.h).
    /// @{
    static ConvexWindow from(std::span<const glm::dvec2> corners);
    static ConvexWindow from(std::initializer_list<glm::dvec2> corners);
    template <class Points>
    static ConvexWindow from(const Points& corners);
    /// @}
};

/// The edges of a window, or the sides of a box. Top is max.y, as in the papers; Near is min.z, Far
/// is max.z.
enum class Edge : std::uint8_t {
    NoEdge,
    Left,
    Right,
    Bottom,
    Top,
    Near,
    Far,
};

/// The edge at the lower and at the upper end of an axis.
constexpr Edge lowerEdge(glm::length_t axis) noexcept { return static_cast<Edge>(1 + 2 * axis); }
constexpr Edge upperEdge(glm::length_t axis) noexcept { return static_cast<Edge>(2 + 2 * axis); }
/// The axis perpendicular to an edge, and the coordinate of the edge's points on that axis. Not for
/// Edge::NoEdge.
constexpr glm::length_t axisOf(Edge edge) noexcept { return (static_cast<int>(edge) - 1) / 2; }
template <class T, glm::length_t N>
constexpr T levelOf(Edge edge, const BasicWindow<T, N>& w) noexcept
{
    return (edge == lowerEdge(axisOf(edge)) ? w.min : w.max)[axisOf(edge)];
}

/// One visible piece of one input segment.
template <class S>
struct BasicClipped {
    S segment;            ///< the piece, from the input's a to its b
    std::uint32_t source; ///< index in the input (a call takes fewer than 2^32 segments)
    std::uint32_t cut;    ///< which ends are new and on which edges; 0: both ends are the input's
};
using Clipped = BasicClipped<Segment>;

/// `Clipped::cut` for a piece whose a was cut at one edge and whose b at another.
constexpr std::uint32_t cutAt(Edge a, Edge b) noexcept
{
    return static_cast<std::uint32_t>(a) | static_cast<std::uint32_t>(b) << 8;
}
/// The edge at which a piece's a was cut; Edge::NoEdge if a is an end of the input.
constexpr Edge cutEdgeOfA(std::uint32_t cut) noexcept { return static_cast<Edge>(cut & 0xff); }
/// The edge at which a piece's b was cut; Edge::NoEdge if b is an end of the input.
constexpr Edge cutEdgeOfB(std::uint32_t cut) noexcept { return static_cast<Edge>(cut >> 8 & 0xff); }

/// For a polygon, `Clipped::cut` holds two numbers of 16 bits: 0 for an end of the input, else 1 +
/// the index of the edge that cut it, and 65535 for edge 65534 and all later ones. Of several
/// collinear edges it is the first one's number; at a corner, the number of one of the two edges
/// that meet there. An edge between two equal corners cuts nothing.
constexpr std::uint32_t edgeNumber(std::size_t index) noexcept
{
    return index < 0xfffe ? static_cast<std::uint32_t>(index + 1) : 0xffff;
}
constexpr std::uint32_t polygonCutAt(std::uint32_t numberOfA, std::uint32_t numberOfB) noexcept
{
    return numberOfA | numberOfB << 16;
}
constexpr std::uint32_t polygonEdgeOfA(std::uint32_t cut) noexcept { return cut & 0xffff; }
constexpr std::uint32_t polygonEdgeOfB(std::uint32_t cut) noexcept { return cut >> 16; }

/// Whether an S has exactly this size, without padding, and may be copied as bytes.
template <class S, std::size_t bytes>
inline constexpr bool isPlain = sizeof(S) == bytes&& std::is_trivially_copyable_v<S>;
static_assert(
    isPlain<
        Segment,
        32> && isPlain<Segment3, 48> && isPlain<BasicSegment<float>, 16> && isPlain<Clipped, 40>,
    "a segment is its numbers and no more: GLM_FORCE_CTOR_INIT, GLM_FORCE_CXX98 and "
    "aligned vectors by default change that");

} // namespace clipping
