// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/nodes/node_picking.h"
#include "ui/tools/tool.h"

namespace ui {

/// What is under the pointer and would be dragged.
struct HoveredNode {
    std::optional<app::NodeAddress> node{};
    std::optional<app::ShownHandle> handle{};
};

/// The handles that are shown; faster for long paths without selected nodes.
std::vector<app::ShownHandle> handlesOf(const app::NodePath& path, const Workbench& bench);

/// Paints the visible nodes: corners as squares, smooth ones as circles, symmetric ones as
/// diamonds, selected ones filled; handles of selected nodes; an arrow at the start of each
/// subpath. Of very many nodes only so many are painted that they do not lie on each other.
void paintNodes(QPainter& painter, const Workbench& bench, const app::NodePath& path,
                const HoveredNode& hovered);

/// Paints the segments beside selected nodes and the one whose handles are dragged, as they would
/// be at the end of the gesture.
void paintChangedSegments(QPainter& painter, const Workbench& bench, const app::NodePath& path,
                          const std::optional<app::NodeAddress>& dragged);

} // namespace ui
