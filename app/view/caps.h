// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/draw_list.h"

#include <QPainterPath>

namespace app {

/// The cap of a stroke that ends at `at` in the direction `away`: a half disc or half square that
/// overlaps the stroke by `overlap`; empty for butt caps. A painter's pen draws the same cap at
/// both ends, but an end made by a cut has none.
QPainterPath capAt(const QPointF& at, const QPointF& away, const StrokeStyle& strokeStyle,
                   double overlap);

} // namespace app
