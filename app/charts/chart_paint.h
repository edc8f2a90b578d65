// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/charts/chart.h"
#include "app/view/chart_look.h"

#include <QRectF>

class QPainter;

namespace app {

// Painting text needs a QGuiApplication; its platform may be "offscreen".

/// Paints the chart from the top of the area, without filling the background. If the area is lower
/// than leastHeight (chart_layout.h), the chart extends beyond the bottom.
void paint(QPainter& painter, const QRectF& area, const Chart& chart, const ChartLook& look);

/// The row at a point of a chart that was painted into that area.
std::optional<std::size_t> rowAt(const QPointF& point, const QRectF& area, const Chart& chart,
                                 const ChartLook& look);

} // namespace app
