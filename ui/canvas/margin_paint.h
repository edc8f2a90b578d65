// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/controller.h"

namespace ui {

/// Paints the margins of the page under the drawing, if they are shown.
void paintMargins(QPainter& painter, const Controller& controller);

} // namespace ui
