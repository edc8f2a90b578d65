// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <type_traits>
#include <vector>

namespace clipping {

/// A directed segment. `a == b` is legal and means a single point.
template <class T, glm::length_t N = 2>
struct BasicSegment {
    glm::vec<N, T> a, b;
    friend constexpr bool operator==(const BasicSegment&, const BasicSegment&) = default;
};

/// A closed window: its edges belong to it. `min == max` is legal; `min > max` contains nothing.
template <class T, glm::length_t N = 2>
struct BasicWindow {
    glm::vec<N, T> min, max;
    friend constexpr bool operator==(const BasicWindow&, const BasicWindow&) = default;
};

using Segment = BasicSegment<double>;
using Window = BasicWindow<double>;

/// A closed convex window: its corners, counter-clockwise where y points up.
struct ConvexPolygon {
    std::vector<glm::dvec2> corners;
};

/// The edges of a window. Top is max.y, as in the paper.
enum class Edge : std::uint8_t { None, Left, Right, Bottom, Top, Near, Far };

/// One visible piece of one input segment.
template <class S>
struct BasicClipped {
    S segment;
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

static_assert(sizeof(Segment) == 32 && std::is_trivially_copyable_v<Segment>);
static_assert(sizeof(Clipped) == 40 && std::is_trivially_copyable_v<Clipped>);

} // namespace clipping
