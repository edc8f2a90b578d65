// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/charts/chart.h"
#include "app/view/chart_look.h"

#include <QRectF>

class QPainter;

namespace app {

// Whoever paints text needs a QGuiApplication; its platform may be "offscreen".

/// Paints the chart into the area, from its top, without filling the ground. Below leastHeight
/// (chart_layout.h) it goes beyond the area's bottom.
void paint(QPainter& painter, const QRectF& area, const Chart& chart, const ChartLook& look);

/// The row under a point of a chart that was painted into that area.
std::optional<std::size_t> rowAt(const QPointF& point, const QRectF& area, const Chart& chart,
                                 const ChartLook& look);

} // namespace app
