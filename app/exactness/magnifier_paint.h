// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exactness/magnified.h"
#include "app/view/chart_look.h"

#include <QPointF>
#include <QRectF>

class QPainter;

namespace app {

/// The scale and the position of the magnified view.
struct MagnifierView {
    double pixelsPerUnit = 1;
    QPointF middle{}; ///< the centre's position relative to the middle of the picture
    Lattice lattice = Lattice::Double;
};
/// Shows the true end and, if possible, the numbers around it.
MagnifierView usualView(const Magnified& seen, const QSizeF& size);
/// Zooms about a point, relative to the middle of the picture; the scale stays within useful
/// bounds.
MagnifierView zoomed(MagnifierView view, const Magnified& seen, double factor,
                     const QPointF& about);

struct MagnifierLook {
    ChartLook chart;
    QColor window, chosen, differs,
        outside; ///< the clip window; the end; an end that is wrong; ground
};

/// An end and the name of its algorithm; both must outlive the call.
struct NamedEnd {
    const Magnified& seen;
    const QString& name;
};

/// Paints the lattice of numbers, the line, the edges, the true end and the algorithm's end, each
/// with its name.
void paintMagnified(QPainter& painter, const QRectF& area, const NamedEnd& end,
                    const MagnifierView& view, const MagnifierLook& look);

/// A description in words: both ends with all digits, and the distance between them.
QString magnifiedText(const Magnified& seen, const QString& name);

} // namespace app
