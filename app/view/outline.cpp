// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/outline.h"

namespace app {

QPainterPath painterPath(const Path& path, FillRule rule)
{
    return painterPath(path.subpaths(), rule);
}

QPainterPath painterPath(std::span<const Subpath> subpaths, FillRule rule)
{
    const auto at = [](const Point& p) { return QPointF(p.x, p.y); };
    QPainterPath outline;
    outline.setFillRule(rule == FillRule::EvenOdd ? Qt::OddEvenFill : Qt::WindingFill);
    for (const Subpath& path : subpaths) {
        outline.moveTo(at(path.start));
        for (const PathSegment& segment : path.segments)
            if (segment.curved)
                outline.cubicTo(at(segment.control1), at(segment.control2), at(segment.to));
            else
                outline.lineTo(at(segment.to));
        if (path.closed)
            outline.closeSubpath();
    }
    return outline;
}

} // namespace app
