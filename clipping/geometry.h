// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace clipping {

/// A directed segment in N dimensions, in whatever unit the window is in too. `a == b` is legal and
/// means a single point.
template <class T, glm::length_t N = 2>
struct BasicSegment {
    static constexpr glm::length_t dimensions = N; ///< how many coordinates a point has
    glm::vec<N, T> a; ///< where it begins
    glm::vec<N, T> b; ///< where it ends
    /// Whether both ends are equal; -0 equals 0, a NaN nothing.
    friend constexpr bool operator==(const BasicSegment&, const BasicSegment&) = default;
};

/// A closed window: its edges belong to it. `min == max` is legal; `min > max` contains nothing.
template <class T, glm::length_t N = 2>
struct BasicWindow {
    glm::vec<N, T> min; ///< the least coordinate on each axis
    glm::vec<N, T> max; ///< the greatest
    /// Whether all edges are equal; -0 equals 0, a NaN nothing.
    friend constexpr bool operator==(const BasicWindow&, const BasicWindow&) = default;
};

using Segment = BasicSegment<double>;
using Window = BasicWindow<double>;
using Segment3 = BasicSegment<double, 3>;
using Window3 = BasicWindow<double, 3>;

/// The line through two points, without ends, directed from a to b. `a == b` is no line, and
/// nothing of it is ever visible.
struct Line {
    glm::dvec2 a; ///< one of its points
    glm::dvec2 b; ///< another one, further on
};
/// The ray from a through b and on. `a == b` has no direction, and nothing of it is ever visible.
struct Ray {
    glm::dvec2 a; ///< where it starts
    glm::dvec2 b; ///< another one, further on
};

/// A closed convex window: its corners, counter-clockwise where y points up. Edge i runs from
/// corner i to the next, the last one to the first. A corner may be there twice, or lie between two
/// others on a line. Corners that all lie in one line are the segment between the outermost of
/// them, one corner is a point. No corner, a clockwise order, a turn to the right, more than one
/// round, a number that is not finite: such a polygon contains nothing.
struct ConvexPolygon {
    std::vector<glm::dvec2> corners; ///< in order
};

/// The edges of a window, and the sides of a box. Top is max.y, as in the paper; Near is min.z, Far
/// max.z.
enum class Edge : std::uint8_t { None, Left, Right, Bottom, Top, Near, Far };

/// The edge at the lower and at the upper end of an axis.
constexpr Edge lowerEdge(glm::length_t axis) { return static_cast<Edge>(1 + 2 * axis); }
constexpr Edge upperEdge(glm::length_t axis) { return static_cast<Edge>(2 + 2 * axis); }
/// The axis across an edge, and the coordinate that its points have on it. Not for Edge::None.
constexpr glm::length_t axisOf(Edge edge) { return (static_cast<int>(edge) - 1) / 2; }
template <class T, glm::length_t N>
constexpr T levelOf(Edge edge, const BasicWindow<T, N>& w)
{
    return (edge == lowerEdge(axisOf(edge)) ? w.min : w.max)[axisOf(edge)];
}

/// One visible piece of one input segment.
template <class S>
struct BasicClipped {
    S segment;            ///< the piece, from the input's a to its b
    std::uint32_t source; ///< index in the input (a call takes fewer than 2^32 segments)
    std::uint32_t cut;    ///< which ends are new and on which edge; 0: the segment is untouched
};
using Clipped = BasicClipped<Segment>;

/// `Clipped::cut` for a piece whose a was cut at one edge and whose b at another.
constexpr std::uint32_t cutAt(Edge a, Edge b)
{
    return static_cast<std::uint32_t>(a) | static_cast<std::uint32_t>(b) << 8;
}
/// The edge on which a piece begins anew; Edge::None if its a is an end of the input.
constexpr Edge cutEdgeOfA(std::uint32_t cut) { return static_cast<Edge>(cut & 0xff); }
/// The edge on which a piece ends anew; Edge::None if its b is an end of the input.
constexpr Edge cutEdgeOfB(std::uint32_t cut) { return static_cast<Edge>(cut >> 8 & 0xff); }

/// Against a polygon, `Clipped::cut` holds two numbers of 16 bits: 0 for an end of the input, else
/// 1 + the index of the edge, and 65535 for edge 65534 and all that follow. Where several edges lie
/// in one line it is the number of the first of them; at a corner, of one of the two that meet
/// there. An edge from a corner to an equal one cuts nothing.
constexpr std::uint32_t edgeNumber(std::size_t index)
{
    return index < 0xfffe ? static_cast<std::uint32_t>(index + 1) : 0xffff;
}
constexpr std::uint32_t polygonCutAt(std::uint32_t numberOfA, std::uint32_t numberOfB)
{
    return numberOfA | numberOfB << 16;
}
constexpr std::uint32_t polygonEdgeOfA(std::uint32_t cut) { return cut & 0xffff; }
constexpr std::uint32_t polygonEdgeOfB(std::uint32_t cut) { return cut >> 16; }

/// Whether an S is its numbers, in so many bytes, and may be copied as bytes.
template <class S, std::size_t bytes>
inline constexpr bool isPlain = sizeof(S) == bytes&& std::is_trivially_copyable_v<S>;
static_assert(
    isPlain<
        Segment,
        32> && isPlain<Segment3, 48> && isPlain<BasicSegment<float>, 16> && isPlain<Clipped, 40>,
    "a segment is its numbers and no more: GLM_FORCE_CTOR_INIT, GLM_FORCE_CXX98 and "
    "aligned vectors by default change that");

} // namespace clipping
