// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/controller.h"

namespace ui {

/// Paints the grid on the page, under the drawing: lines of one device pixel, or dots.
void paintGrid(QPainter& painter, const Controller& controller);

} // namespace ui
