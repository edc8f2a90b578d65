// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/controller.h"

namespace ui {

/// Where the size of the chosen clip window, or its position or angle during a drag, is written
/// below or above the window, which is `window` on the screen. `font` is the painter's.
QRectF windowLabelPlace(const Controller& controller, const QRectF& window, const QFont& font);
void paintWindowLabel(QPainter& painter, const Controller& controller, const QRectF& window);

} // namespace ui
