// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/region/beside.h"
#include "clipping/region/edges.h"
#include "clipping/region/winding.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace clipping {

/// Finds the edges near a segment where many long edges are beside each other: the teeth of a
/// comb, rays, hatching. Cells of a grid would each list very many of them.
///
/// A binary space partition (Paterson and Yao, "Efficient binary space partitions for
/// hidden-surface removal and solid modeling", Discrete & Computational Geometry 5, 1990): each
/// node is the line of an edge, so that edges beside it are not divided; around a convex area, it
/// goes through two corners, so that a segment across the area passes few nodes. Wherever an edge
/// and a segment meet, the segment passes a leaf that lists the edge; margins are larger than all
/// rounding.
///
/// A few leaves at a time share a reference point near to them, with the winding numbers there.
class EdgeTree {
public:
    /// Whether the partition works for a box: its extents are neither tiny nor huge.
    static bool suits(const Window& box);
    /// For edges whose box `suits`. They are not kept. Leaves of `smallLeaf` edges are not divided.
    EdgeTree(std::span<const AreaEdge> edges, std::size_t steps, const Window& box,
             std::size_t smallLeaf = 8);

    /// Calls `visit(indices)` with the edges of all leaves that a segment passes. An edge may be in
    /// several.
    template <class Visit>
    void trace(const Segment& s, Visit&& visit) const;

    /// A point, and the winding numbers there.
    struct Anchor {
        Reference reference;
        std::span<const Winding> windings;
    };
    /// One near to a point: few edges are between them.
    Anchor anchorNear(const glm::dvec2& p) const;

private:
    class Builder;
    static constexpr std::uint32_t mostDepth = 64;

    /// A part of an edge or of a segment: from one share of its way to another.
    struct Part {
        double from, to;
        bool isEmpty() const { return from > to; }
    };
    /// The half planes are where the value of a point, measured along `normal`, is positive or
    /// negative.
    struct Line {
        glm::dvec2 at, normal; ///< the normal's longer coordinate is 1 or -1

        /// The parts of a segment on both sides, none too short.
        std::array<Part, 2> sidesOf(const Segment& s, const Part& part, double margin) const;
    };
    struct Node {
        Line line;
        std::array<std::uint32_t, 2> children; ///< of the positive side, of the negative side
    };
    /// In the number of a child that is a leaf, not a node.
    static constexpr std::uint32_t leafBit = 0x80000000;

    void divide(std::span<const AreaEdge> edges, std::size_t steps, std::size_t smallLeaf);
    void findWindings(std::span<const AreaEdge> edges, std::size_t steps, const Window& box);

    double margin_; ///< all points so near to a line are on both sides of it
    std::uint32_t root_;
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> firstEdge_{0}, edges_; ///< of the leaves
    std::vector<std::uint32_t> anchorOf_;             ///< of each leaf
    std::vector<glm::dvec2> anchors_;
    std::vector<std::uint32_t> firstWinding_{0};
    std::vector<Winding> windings_;
};

inline std::array<EdgeTree::Part, 2> EdgeTree::Line::sidesOf(const Segment& s, const Part& part,
                                                             double margin) const
{
    const glm::dvec2 a = (s.a - at) * normal, b = (s.b - at) * normal;
    const double atA = a.x + a.y, atB = b.x + b.y;
    // Differences, products, sums and the share err by less than 16 units of 2^-53 of these terms.
    const double more =
        margin + 0x1p-49 * (std::abs(a.x) + std::abs(a.y) + std::abs(b.x) + std::abs(b.y));
    const double first = atA + part.from * (atB - atA), last = atA + part.to * (atB - atA);
    const auto side = [&](double sign) -> Part {
        const bool entersLate = sign * first < -more, leavesEarly = sign * last < -more;
        if (!entersLate && !leavesEarly) // also if a number is not finite
            return part;
        if (entersLate && leavesEarly)
            return {1, 0};
        const double crossing = (sign * atA + more) / (sign * (atA - atB));
        return entersLate ? Part{std::max(part.from, crossing), part.to}
                          : Part{part.from, std::min(part.to, crossing)};
    };
    return {side(1), side(-1)};
}

template <class Visit>
void EdgeTree::trace(const Segment& s, Visit&& visit) const
{
    struct Ahead {
        std::uint32_t child;
        Part part;
    };
    std::array<Ahead, mostDepth + 1> ahead;
    std::size_t count = 0;
    ahead[count++] = {root_, {0, 1}};
    while (count > 0) {
        const auto [child, part] = ahead[--count];
        if (child & leafBit) {
            const std::uint32_t leaf = child & ~leafBit;
            visit(std::span(edges_).subspan(firstEdge_[leaf],
                                            firstEdge_[leaf + 1] - firstEdge_[leaf]));
            continue;
        }
        const Node& node = nodes_[child];
        const auto sides = node.line.sidesOf(s, part, margin_);
        for (std::size_t i = 0; i < 2; ++i)
            if (!sides[i].isEmpty())
                ahead[count++] = {node.children[i], sides[i]};
    }
}

} // namespace clipping
