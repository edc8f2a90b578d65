// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/controller.h"

namespace ui {

/// The clip window: outline with casing; in the active pane handles, and the label that says its
/// size or place.
void paintWindow(QPainter& painter, const Controller& controller, const Pane& pane);

/// The nine regions around it with their outcodes.
void paintRegions(QPainter& painter, const Controller& controller);

} // namespace ui
