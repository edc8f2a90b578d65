// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/painter_path.h"

namespace app {

QPainterPath painterPath(const Shape& shape)
{
    const auto at = [](const Point& p) { return QPointF(p.x, p.y); };
    QPainterPath outline;
    outline.setFillRule(shape.style.fillRule == FillRule::EvenOdd ? Qt::OddEvenFill
                                                                  : Qt::WindingFill);
    for (const Path& path : shape.paths) {
        outline.moveTo(at(path.start));
        for (const Stretch& stretch : path.stretches)
            if (stretch.curved)
                outline.cubicTo(at(stretch.control1), at(stretch.control2), at(stretch.to));
            else
                outline.lineTo(at(stretch.to));
        if (path.closed)
            outline.closeSubpath();
    }
    return outline;
}

} // namespace app
