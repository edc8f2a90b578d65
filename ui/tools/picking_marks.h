// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/tool.h"

namespace ui {

/// What lies under the pointer: a segment of the scene and its object, or the object in whose area
/// it is.
struct Picked {
    std::optional<std::size_t> segment, object;
};
Picked pickedAt(const app::Point& pointer, const Workbench& bench);

/// Paints the box that is dragged around what it will select.
void paintSelectionBox(QPainter& painter, const Workbench& bench, const app::Point& from,
                       const app::Point& to, Qt::PenStyle edge = Qt::SolidLine);

} // namespace ui
