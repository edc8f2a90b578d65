// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/controller.h"

namespace ui {

/// Paints a label in the lower left corner of a pane whose results differ from `exact`: the number
/// of differing lines in words, with a sample of their marking.
void paintDifferenceLabel(QPainter& painter, const Controller& controller, const Pane& pane);
/// The height of that label with its margins, in logical pixels; 0: no label.
double differenceLabelHeight(const Controller& controller, const Pane& pane);

} // namespace ui
