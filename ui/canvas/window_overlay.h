// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/controller.h"

namespace ui {

/// The clip window: outline with casing; in the active pane handles, and the label that says its
/// size or place.
void paintWindow(QPainter& painter, const Controller& controller, const Pane& pane);
/// Where its outline, its handles and its label are in a pane: nothing else may hide them. `font` is the
/// painter's.
std::vector<QRectF> windowFurniture(const Controller& controller, const Pane& pane,
                                    const QFont& font);

} // namespace ui
