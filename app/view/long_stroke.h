// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/draw_list.h"
#include "app/view/raster.h"

#include <QTransform>

namespace app {

/// A wide stroke; the referenced objects must outlive it.
struct LongStroke {
    std::span<const QPointF> points;
    const Polyline& polyline;
    const StrokeStyle& strokeStyle;
};

using VisitContour = std::function<void(std::span<const QPointF> contour)>;

/// Visits the contours of the stroke piece by piece, in device pixels. Together they cover exactly
/// the stroke, and no part of it twice. If cancelled, some contours are missing.
void visitContours(const LongStroke& stroke, const QTransform& toDevice, const Cancelled& cancelled,
                   const VisitContour& visit);

} // namespace app
