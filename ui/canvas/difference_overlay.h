// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/controller.h"

namespace ui {

/// Over a pane whose algorithm leaves other lines than exact: how many, in words, with a sample of
/// how they are marked. In the lower left corner.
void paintDifferenceLabel(QPainter& painter, const Controller& controller, const Pane& pane);
/// The height of that label with the room around it; 0: there is none.
double differenceLabelHeight(const Controller& controller, const Pane& pane);

} // namespace ui
