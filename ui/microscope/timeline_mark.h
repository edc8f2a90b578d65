// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/walk.h"

#include <QPainter>

namespace ui {

/// The sign of a step on the timeline and in its legend, around a point, 14 pixels high at the
/// most: a tick, a divided circle, a diamond, a tick or a cross in a circle. `ground` is below it.
void paintMark(QPainter& painter, const QPointF& middle, app::Mark mark, const QColor& ink,
               const QColor& ground);
/// "compare", "cut".
QString markWord(app::Mark mark);

} // namespace ui
