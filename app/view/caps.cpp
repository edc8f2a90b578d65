// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/caps.h"

#include "app/document/dash_parts.h"

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

std::vector<std::vector<QPointF>> dashes(std::span<const QPointF> polyline,
                                         std::span<const double> pattern, double phase,
                                         double shortest)
{
    std::vector<double> lengths;
    for (std::size_t i = 1; i < polyline.size(); ++i) {
        const QPointF along = polyline[i] - polyline[i - 1];
        lengths.push_back(std::hypot(along.x(), along.y()));
    }
    const auto parts = dashParts(lengths, pattern, phase, shortest);
    if (!parts)
        return {{polyline.begin(), polyline.end()}};
    std::vector<std::vector<QPointF>> all;
    for (const DashPart& part : *parts) {
        const QPointF from = polyline[part.line], along = polyline[part.line + 1] - from;
        if (part.begins)
            all.push_back({from + along * part.from});
        all.back().push_back(from + along * part.to);
    }
    return all;
}

} // namespace app
