// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/controller.h"

namespace ui {

/// What both canvases paint under the art: the page and what is around it.
void paintPaper(QPainter& painter, const Controller& controller);

/// And over it: what the algorithm sees, what is lit, selected or inspected, the clip window with its handles and
/// size, the tool's preview, where the pointer snapped (look.md section 5).
void paintOverlay(QPainter& painter, const Controller& controller, const Pane& pane);

} // namespace ui
