// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/controller.h"

namespace ui {

/// Paints what the pane's algorithm sees: of one line (the line being drawn, else the inspected
/// one, else the hovered one) and of the pointer's position.
void paintWhatIsSeen(QPainter& painter, const Controller& controller, const Pane& pane);

} // namespace ui
