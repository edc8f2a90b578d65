// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/snapping/marker_place.h"

#include <algorithm>

namespace app {

constexpr double beside = 12, above = 9, gap = 4; // pixels

QRectF markerPlace(const QPointF& at, const QSizeF& label, const QSizeF& canvas,
                   const QRectF& covered)
{
    const QRectF room({0, 0}, canvas);
    for (const bool below : {false, true})
        for (const bool right : {false, true}) {
            const QPointF corner(right ? at.x() + beside : at.x() - beside - label.width(),
                                 below ? at.y() + above : at.y() - above - label.height());
            const QRectF place(corner, label);
            if (room.contains(place) && !place.intersects(covered))
                return place;
        }
    QRectF place({at.x() - label.width() / 2, covered.top() - gap - label.height()}, label);
    if (place.top() < 0)
        place.moveTop(covered.bottom() + gap);
    place.moveLeft(std::clamp(place.left(), 0.0, std::max(0.0, canvas.width() - label.width())));
    return place;
}

} // namespace app
