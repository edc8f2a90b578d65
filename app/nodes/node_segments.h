// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/nodes/node_moves.h"

// Straight and curved segments. A segment has the number of the node where it begins.

namespace app {

/// The segments between two selected nodes; if there are none, those beside a selected node.
std::vector<NodeAddress> chosenSegments(const NodePath& path);

void straightenSegment(NodeSubpath& subpath, std::size_t segment);
/// A straight segment becomes a curve of the same shape, with its handles at its thirds.
void curveSegment(NodeSubpath& subpath, std::size_t segment);

/// Makes the chosen segments straight or curved. Whether any segment changed.
bool makeStraight(NodePath& path);
bool makeCurved(NodePath& path);

/// Adds a node to a segment, 0 < t < 1, without changing its shape: a straight one stays straight,
/// a curve is divided by de Casteljau's algorithm. The number of the new node; empty: refused.
std::optional<std::size_t> insertNode(NodeSubpath& subpath, std::size_t segment, double t);
/// Adds a node in the middle of each chosen segment, and selects the new nodes too. Whether there
/// was any.
bool insertInChosen(NodePath& path);

} // namespace app
