// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/controller.h"

namespace ui {

/// Paints what both canvases have under the drawing: the page and its surroundings.
void paintPaper(QPainter& painter, const Controller& controller);

/// Paints what both canvases have over the drawing: what the algorithm sees; the hovered, selected
/// or inspected lines; the clip window with handles and size; the tool's preview; the snap point.
/// `shown` is the frame of the picture, or null: outlines belong to its cut.
void paintOverlay(QPainter& painter, const Controller& controller, const Pane& pane,
                  const app::FrameKey* shown);

/// Paints what the pane's algorithm sees: of one line (the line being drawn, else the inspected
/// one, else the hovered one) and of the pointer's position.
void paintWhatIsSeen(QPainter& painter, const Controller& controller, const Pane& pane);

} // namespace ui
