// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/node_painter.h"

namespace ui {

const app::Node& nodeOf(const app::NodeAddress& address, const Workbench& bench);

/// What a press of the tool Nodes grabs: a node or a handle, else a segment with its two nodes.
struct GrabbedNodes {
    HoveredNode point{};
    std::optional<app::SegmentPoint> segment{};

    static GrabbedNodes at(const Pointer& pointer, const Workbench& bench);
    bool isNothing() const { return !point.node && !point.handle && !segment; }
    std::vector<app::NodeAddress> nodes(const Workbench& bench) const; ///< none of a handle
    bool areSelected(const Workbench& bench) const;                    ///< all of them
    bool isCurved(const Workbench& bench) const;                       ///< a segment, which is bent
    /// Selects its nodes as a click does: with Shift beside the others, where a single one is
    /// deselected again.
    void select(Qt::KeyboardModifiers modifiers, Workbench& bench) const;
};

} // namespace ui
