// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/controller.h"

// Without a clip window, tools that move clip windows offer to add one on the page: a handle at the
// page's bottom edge.

namespace ui {

/// The handle's rectangle, in logical pixels; empty if nothing is offered.
QRectF offerPlace(const Controller& controller);
void paintOffer(QPainter& painter, const Controller& controller, const Pane& pane);

} // namespace ui
