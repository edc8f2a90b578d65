// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/draw_list.h"

#include <QPainterPath>
#include <QPointF>

#include <span>
#include <vector>

namespace app {

/// The cap of a stroke that ends at `at` in the direction `away`: a half disc or half square that
/// overlaps the stroke by `overlap`; empty for butt caps. A painter's pen draws the same cap at
/// both ends, but an end made by a cut has none.
QPainterPath capAt(const QPointF& at, const QPointF& away, const StrokeStyle& strokeStyle,
                   double overlap);

/// Cuts a polyline into its dashes (app/document/dash_parts.h); lengths are in the unit of the
/// points. The dashes are in order, each with at least two points. A solid line is one of them.
std::vector<std::vector<QPointF>> dashes(std::span<const QPointF> polyline,
                                         std::span<const double> pattern, double phase,
                                         double shortest);

} // namespace app
