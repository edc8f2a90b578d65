// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/controller.h"

namespace ui {

/// Paints the place that the pointer, or what it moves, snaps to: a ring, and its kind by glyph and
/// name; and the lines of what is aligned, with distances.
void paintSnapMarker(QPainter& painter, const Controller& controller);

} // namespace ui
