// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cost_map/legend.h"
#include "app/view/chart_look.h"

#include <QRectF>

class QPainter;

namespace app {

// Painting text needs a QGuiApplication; its platform may be "offscreen".

/// The colours and fonts of a cost map.
struct CostMapLook {
    ChartLook chart;
    QColor window; ///< the outline of the clip window
};
/// The look for files, like chartLook().
CostMapLook costMapLook(Ground ground);

/// The part of `room` that a map fills: the largest rectangle with the proportions of its area.
QRectF mapPlace(const CostPlan& plan, const QRectF& room);
/// Conversion between the plane and a map that fills `place`.
QPointF onMap(const CostPlan& plan, const QRectF& place, const Point& point);
Point onPlane(const CostPlan& plan, const QRectF& place, const QPointF& pixel);

/// Whether labels are written into regions that have room for them.
enum class RegionLabels : std::uint8_t { None, Shown };

/// Paints the cells (stripes for a tie), the labels of regions, the clip window and the fixed end
/// into `place`. Cells that are not computed yet are not painted.
void paintMap(QPainter& painter, const QRectF& place, const CostMap& map, const CostMapLook& look,
              RegionLabels labels);

/// Paints the meaning of the colours, from the top of `room` down.
void paintLegend(QPainter& painter, const QRectF& room, const CostMap& map,
                 const CostMapLook& look);
double legendHeight(const CostMap& map, double width, const CostMapLook& look);

} // namespace app
