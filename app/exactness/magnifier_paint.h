// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exactness/magnified.h"
#include "app/view/chart_look.h"

#include <QPointF>
#include <QRectF>

class QPainter;

namespace app {

/// How a magnified end is looked at.
struct MagnifierView {
    double pixelsPerUnit = 1;
    QPointF middle{}; ///< where the centre is, from the middle of the picture
    Lattice lattice = Lattice::Double;
};
/// With the true end in sight, and if possible the numbers around it.
MagnifierView usualView(const Magnified& seen, const QSizeF& size);
/// Zooms about a point, counted from the middle of the picture, as far as there is anything to see.
MagnifierView zoomed(MagnifierView view, const Magnified& seen, double factor,
                     const QPointF& about);

struct MagnifierLook {
    ChartLook chart;
    QColor window, chosen, differs,
        outside; ///< the clip window; the end; one that is wrong; ground
};

/// An end and the name of the algorithm that it is of, for the length of a call.
struct NamedEnd {
    const Magnified& seen;
    const QString& name;
};

/// The lattice of numbers, the line, the edges, the true end and the algorithm's, each with its
/// name.
void paintMagnified(QPainter& painter, const QRectF& area, const NamedEnd& end,
                    const MagnifierView& view, const MagnifierLook& look);

/// What is seen, in words: both ends with all digits, and how far they are apart.
QString magnifiedText(const Magnified& seen, const QString& name);

} // namespace app
