// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/held_tool.h"

// Without a clip window, tools that move clip windows offer to add one on the page: a handle at the
// page's bottom edge.

namespace ui {

/// The handle's rectangle, in logical pixels; empty if none is offered.
QRectF offeredHandle(const HeldTool& held);
/// `pointer` highlights the handle if it is over it; `ground` is the colour behind the text.
void paintOffer(QPainter& painter, const QRectF& place, const std::optional<Pointer>& pointer,
                const Look& look, const QColor& ground);

} // namespace ui
