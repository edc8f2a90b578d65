// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/bezier.h"
#include "app/document/path.h"

#include <optional>
#include <span>
#include <vector>

namespace app {

/// How the two handles of a node follow each other. Each type includes the one before it.
enum class NodeType : std::uint8_t {
    Corner,   ///< they are independent
    Smooth,   ///< they are in line
    Symmetric ///< they are in line and equally long
};

/// A point where path segments meet.
struct Node {
    Point at;
    Point in, out; ///< control points; equal to `at` beside a straight segment
    NodeType type = NodeType::Corner;
    bool curved = false; ///< the segment to the next node
    bool selected = false;
    friend bool operator==(const Node&, const Node&) = default;
};

/// A subpath that can be edited. In a closed one, the last segment leads back to the first node;
/// a closed one with a single node has a segment only if it is curved.
struct NodeSubpath {
    std::vector<Node> nodes;
    bool closed = false;

    std::size_t segmentCount() const;
    std::optional<std::size_t> next(std::size_t node) const;     ///< empty at an open end
    std::optional<std::size_t> previous(std::size_t node) const; ///< empty at an open end
    bool isEnd(std::size_t node) const { return !next(node) || !previous(node); }
    bool curvedInto(std::size_t node) const; ///< whether the segment before the node is curved
    /// The segment from this node to the next; a straight one with its controls at its thirds.
    Bezier segment(std::size_t node) const;
    friend bool operator==(const NodeSubpath&, const NodeSubpath&) = default;
};
using NodePath = std::vector<NodeSubpath>;

/// The nodes of a path. Their types follow from the handles (node_types.h); none is selected.
NodePath nodesOf(std::span<const Subpath> subpaths);
/// The path through these nodes, with the same numbers.
std::vector<Subpath> subpathsOf(std::span<const NodeSubpath> path);

std::size_t nodeCount(std::span<const NodeSubpath> path);
std::size_t selectedCount(std::span<const NodeSubpath> path);
bool isFinite(std::span<const NodeSubpath> path); ///< every point of it
void selectAll(std::span<NodeSubpath> path, bool selected);

} // namespace app
