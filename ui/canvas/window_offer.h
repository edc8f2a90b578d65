// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/controller.h"

// Without a clip window, the tools that could move one offer to lay it on the page: a handle at the
// page's lower edge.

namespace ui {

/// Where it is, in logical pixels; empty where there is nothing to offer.
QRectF offerPlace(const Controller& controller);
void paintOffer(QPainter& painter, const Controller& controller, const Pane& pane);

} // namespace ui
