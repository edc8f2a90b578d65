// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/narration.h"

#include <QPainter>

namespace ui {

/// Paints a step's mark on the timeline or in its legend, centred on `middle` and at most 14 pixels
/// high: a dot, a vertical line, a divided circle, a diamond, or a circle with a tick, a cross or
/// an exclamation mark. `ground` is the background colour.
void paintMark(QPainter& painter, const QPointF& middle, app::Mark mark, const QColor& colour,
               const QColor& ground);
/// The word for a mark: "compare", "cut".
QString markWord(app::Mark mark);

} // namespace ui
