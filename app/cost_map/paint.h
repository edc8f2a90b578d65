// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cost_map/legend.h"
#include "app/view/chart_look.h"

#include <QRectF>

class QPainter;

namespace app {

// Whoever paints text needs a QGuiApplication; its platform may be "offscreen".

/// What a cost map is painted with.
struct CostMapLook {
    ChartLook chart;
    QColor window; ///< the outline of the clip window
};
/// For files, as chartLook().
CostMapLook costMapLook(Ground ground);

/// The part of a rectangle that a map fills: as large as fits, in the shape of its area.
QRectF mapPlace(const CostPlan& plan, const QRectF& room);
/// Between the plane and a map that fills `place`.
QPointF onMap(const CostPlan& plan, const QRectF& place, const Point& point);
Point onPlane(const CostPlan& plan, const QRectF& place, const QPointF& pixel);

/// What is written into a region that has room for it.
enum class RegionLabels : std::uint8_t { None, Shown };

/// Cells (of a tie: stripes of all that tie), labels of regions, the clip window and the fixed end
/// into a place. Cells that are not computed yet stay as they are.
void paintMap(QPainter& painter, const QRectF& place, const CostMap& map, const CostMapLook& look,
              RegionLabels labels);

/// The meaning of the colours, from the top of a rectangle down.
void paintLegend(QPainter& painter, const QRectF& room, const CostMap& map,
                 const CostMapLook& look);
double legendHeight(const CostMap& map, double width, const CostMapLook& look);

} // namespace app
