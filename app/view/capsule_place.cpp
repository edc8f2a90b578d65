// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/capsule_place.h"

#include "app/base/text.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace app {
namespace {

constexpr double fromBox = 13, fromEdge = 8, insideEdge = 12; // pixels
constexpr double leastSeen = 16;                              // more than a handle

double distanceFrom(const QRectF& place, const QPointF& point)
{
    const double x = std::max({place.left() - point.x(), point.x() - place.right(), 0.0});
    const double y = std::max({place.top() - point.y(), point.y() - place.bottom(), 0.0});
    return std::hypot(x, y);
}

/// In a row of the canvas: in the middle of the box, else at one of its sides.
std::optional<QRectF> placeInRow(double top, const QSizeF& size, const CapsuleRoom& room)
{
    const double last = room.canvas.width() - fromEdge - size.width();
    if (top < fromEdge || top + size.height() > room.canvas.height() - fromEdge || last < fromEdge)
        return std::nullopt;
    const std::array lefts{room.box.center().x() - size.width() / 2, room.box.left(),
                           room.box.right() - size.width()};
    for (const double left : lefts) {
        const QRectF place(QPointF(std::round(std::clamp(left, fromEdge, last)), std::round(top)),
                           size);
        if (std::ranges::none_of(room.covered,
                                 [&](const QRectF& other) { return place.intersects(other); }))
            return place;
    }
    return std::nullopt;
}

} // namespace

std::span<const CapsuleHomeInfo> capsuleHomes()
{
    using enum CapsuleHome;
    static const std::array all{
        CapsuleHomeInfo{AtObject, "object", Text::tr("At the object")},
        CapsuleHomeInfo{InBar, "bar", Text::tr("In the options bar")},
        CapsuleHomeInfo{Off, "off", Text::tr("Off", "the capsule is not shown")}};
    return all;
}

CapsuleHome capsuleHomeOf(const QString& key)
{
    const auto found = std::ranges::find(capsuleHomes(), key.toStdString(), &CapsuleHomeInfo::key);
    return found == capsuleHomes().end() ? CapsuleHome::AtObject : found->home;
}

std::optional<QPointF> capsulePlace(const QSizeF& size, const CapsuleRoom& room)
{
    const QRectF canvas(QPointF(), room.canvas);
    const QRectF seen = room.box & canvas;
    const double enough = std::min(leastSeen, room.box.width());
    if (seen.width() < enough || seen.height() < std::min(leastSeen, room.box.height())
        || seen.isEmpty())
        return std::nullopt;
    const auto below = placeInRow(room.box.bottom() + fromBox, size, room);
    const auto above = placeInRow(room.box.top() - fromBox - size.height(), size, room);
    if (below && above && room.released)
        return distanceFrom(*above, *room.released) < distanceFrom(*below, *room.released)
                   ? above->topLeft()
                   : below->topLeft();
    if (below || above)
        return below ? below->topLeft() : above->topLeft();
    const auto inside = placeInRow(seen.bottom() - insideEdge - size.height(), size, room);
    return inside ? std::optional(inside->topLeft()) : std::nullopt;
}

} // namespace app
