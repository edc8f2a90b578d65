// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/left_alone_mark.h"

#include "app/scene/window_needs.h"
#include "ui/canvas/window_overlay.h"
#include "ui/canvas/window_tags.h"
#include "ui/look/text.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

constexpr double fading = 0.78, besideWords = 10, aboveWords = 6; // logical pixels
constexpr double apart = 8, edge = 2;

/// The place of a box of that size: in the middle of what is seen of the window, or beside it.
/// Empty: there is no room for it.
QRectF placeFor(const QSizeF& size, const QRectF& window, const QRectF& room,
                std::span<const QRectF> taken)
{
    const QRectF seen = window & room;
    const QPointF middle = seen.center();
    const double farthest = std::max(room.left(), room.right() - size.width());
    const auto at = [&](double x, double y) { // moved into the room, as far as it is at a side
        return QRectF(std::round(std::clamp(x - size.width() / 2, room.left(), farthest)),
                      std::round(y - size.height() / 2), size.width(), size.height());
    };
    const double up = (seen.height() + size.height()) / 2 + apart,
                 aside = (seen.width() + size.width()) / 2 + apart;
    const QRectF inside = at(middle.x(), middle.y());
    if (seen.contains(inside))
        return inside;
    for (const QRectF& place :
         {at(middle.x(), middle.y() - up), at(middle.x(), middle.y() + up),
          at(middle.x() + aside, middle.y()), at(middle.x() - aside, middle.y())})
        if (room.contains(place) && !place.intersects(seen)
            && std::ranges::none_of(
                taken, [&place](const QRectF& other) { return other.intersects(place); }))
            return place;
    return {};
}

/// Paints the box that says why: in the middle of such a window, or beside it if that is too
/// small. It does not cover what is `taken`; without another place there is no box.
void paintWhyLeftAlone(QPainter& painter, const Controller& controller, const QRectF& window,
                       const QString& why, std::span<const QRectF> taken)
{
    const QRectF room(0, 0, controller.view().size.x, controller.view().size.y);
    if (!room.intersects(window))
        return;
    const Look& look = controller.paperLook();
    const QFont usual = painter.font(), bold = semiBold(usual);
    const QString title = Text::tr("Not clipped here");
    const QFontMetricsF first(bold), second(usual);
    const double width = std::max(first.horizontalAdvance(title), second.horizontalAdvance(why));
    const QSizeF size(std::ceil(width + 2 * besideWords),
                      std::ceil(first.height() + second.height() + 2 * aboveWords));
    const QRectF box = placeFor(size, window, room.adjusted(edge, edge, -edge, -edge), taken);
    if (box.isEmpty())
        return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(look.border, 1));
    painter.setBrush(look.base);
    painter.drawRoundedRect(box.adjusted(0.5, 0.5, -0.5, -0.5), space::radius, space::radius);
    const QRectF text = box.adjusted(0, aboveWords, 0, -aboveWords);
    painter.setFont(bold);
    painter.setPen(look.text);
    painter.drawText(text, Qt::AlignHCenter | Qt::AlignTop, title);
    painter.setFont(usual);
    painter.setPen(look.muted);
    painter.drawText(text, Qt::AlignHCenter | Qt::AlignBottom, why);
    painter.restore();
}

} // namespace

void paintLeftAlone(QPainter& painter, const Controller& controller, const QPainterPath& outline)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    QColor fade = controller.pageColour();
    fade.setAlphaF(fading);
    const bool ghosted = controller.session().display().removed == app::RemovedPart::Ghosted;
    QPen dots(controller.paperLook().accent, 1, Qt::SolidLine, Qt::FlatCap);
    dots.setDashPattern({2, 3});
    painter.setPen(dots);
    painter.setBrush(ghosted ? QBrush(fade) : QBrush(Qt::NoBrush));
    painter.drawPath(outline);
    painter.restore();
}

void paintReasons(QPainter& painter, const Controller& controller, const Pane& pane)
{
    if (!hasReasons(pane))
        return;
    const auto& steps = controller.session().region().steps;
    for (const std::size_t step : pane.leftAlone) {
        std::vector<QRectF> taken;
        for (std::size_t other = 0; other < steps.size(); ++other)
            if (other != step)
                taken.push_back(boxOnScreen(controller.view(), steps[other].box));
        if (pane.active)
            for (const WindowTag& tag : windowTags(controller.held(), painter.font()))
                taken.push_back(tag.place);
        paintWhyLeftAlone(painter, controller, boxOnScreen(controller.view(), steps[step].box),
                          app::limitText(pane.choice, app::needsOf(steps[step])), taken);
    }
}

} // namespace ui
