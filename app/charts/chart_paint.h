// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/charts/chart.h"
#include "app/charts/chart_look.h"

#include <QRectF>

class QPainter;

namespace app {

// Whoever paints text needs a QGuiApplication; its platform may be "offscreen".

/// Paints the chart into the area, from its top, without filling the ground. Below leastHeight
/// (chart_layout.h) it goes beyond the area's bottom.
void paint(QPainter& painter, const QRectF& area, const Chart& chart, const ChartLook& look);

/// What is under a point of a chart that was painted into that area.
struct ChartHit {
    std::size_t row;
    std::optional<std::size_t> panel; ///< none beside them
    std::optional<double> value;      ///< of the axis there
    friend bool operator==(const ChartHit&, const ChartHit&) = default;
};
std::optional<ChartHit> hitAt(const QPointF& point, const QRectF& area, const Chart& chart,
                              const ChartLook& look);

} // namespace app
