// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/controller.h"

namespace ui {

/// What the pane's algorithm sees of the line that is looked at: the one that is being drawn, else
/// the one in the inspector, else the one under the pointer; and of the pointer's place.
void paintWhatIsSeen(QPainter& painter, const Controller& controller, const Pane& pane);

} // namespace ui
