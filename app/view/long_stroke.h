// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/raster.h"

#include <QTransform>

namespace app {

/// A wide stroke; what it refers to outlives it.
struct LongStroke {
    std::span<const QPointF> points;
    const Chain& chain;
    const Ink& ink;
};

using VisitContour = std::function<void(std::span<const QPointF> contour)>;

/// The contours of the stroke, in device pixels, piece by piece: together they cover what the
/// stroke covers, and none of it twice. Cancelled: not all of them.
void visitContours(const LongStroke& stroke, const QTransform& toDevice, const Cancelled& cancelled,
                   const VisitContour& visit);

} // namespace app
