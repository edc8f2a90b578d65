// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/controller.h"

namespace ui {

/// Shows which group is entered: a frame with its name; what is outside the frame is paler.
void paintEnteredGroup(QPainter& painter, const Controller& controller);

/// A thin frame around the group that a click would select.
void paintHoveredGroup(QPainter& painter, const Controller& controller, std::size_t segment);

} // namespace ui
