// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/caps.h"

#include <QTransform>

#include <cmath>

namespace app {

QPainterPath capAt(const QPointF& at, const QPointF& away, const StrokeStyle& strokeStyle,
                   double overlap)
{
    QPainterPath cap; // for a stroke that comes from the left and ends at 0
    const double r = strokeStyle.width / 2;
    if (strokeStyle.cap == Cap::Square)
        cap.addRect(QRectF(-overlap, -r, r + overlap, 2 * r));
    if (strokeStyle.cap == Cap::Round) {
        cap.moveTo(-overlap, r);
        cap.lineTo(0, r);
        cap.arcTo(QRectF(-r, -r, 2 * r, 2 * r), -90, 180);
        cap.lineTo(-overlap, -r);
        cap.closeSubpath();
    }
    const double degrees = std::atan2(away.y(), away.x()) * 180 / M_PI;
    return QTransform().translate(at.x(), at.y()).rotate(degrees).map(cap);
}

} // namespace app
