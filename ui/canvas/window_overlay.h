// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/controller.h"

namespace ui {

/// A box in screen coordinates, limited to the visible range, because painters fail with
/// coordinates like 1e9.
QRectF boxOnScreen(const app::View& view, const clipping::Window& window);

/// The outlines that are long; the picture shows them.
std::vector<app::BorderLine> longBorders(const Workbench& bench, const Pane& pane);
/// Paints the clip window: its outline with a casing, unless it is long, and, in the active pane,
/// its handles and, without a capsule, a label with its size or position. The outline is where the
/// window was in the frame `shown`, if that is an earlier one: cut and outline move together, and
/// only the handles go ahead with the pointer. A window that the pane's variant leaves alone has a
/// dotted outline, and a box that says so.
void paintWindow(QPainter& painter, const Controller& controller, const Pane& pane,
                 const app::FrameKey* shown);
/// The chosen window with its handles, and what its capsule must not cover: these, names and small
/// windows. In logical pixels; there is such a window. `font` is the surface's.
QRectF windowBox(const Controller& controller);
std::vector<QRectF> windowMarks(const Controller& controller, const QFont& font);
/// The boxes of the clip window's outline, handles and label in a pane: nothing else may cover
/// them. `font` is the painter's.
std::vector<QRectF> windowFurniture(const Controller& controller, const Pane& pane,
                                    const QFont& font);

} // namespace ui
