// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/window_offer.h"

#include "ui/look/text.h"

#include <QFontMetricsF>
#include <QGuiApplication>

#include <algorithm>

namespace ui {
namespace {

constexpr double underWindow = 13, fromEdge = 4; // pixels

QString text() { return Text::tr("Lay window on page"); }

} // namespace

QRectF offeredHandle(const HeldTool& held)
{
    if (held.session().clipWindow() || !held.info().showsHandles())
        return {};
    const clipping::Window page = held.session().now().page().rectangle();
    const app::View& view = held.view();
    const app::Point min = view.toScreen(page.min), max = view.toScreen(page.max);
    const QSizeF size =
        QFontMetricsF(QGuiApplication::font()).boundingRect(text()).size() + QSizeF(20, 8);
    const double x =
        (std::clamp(min.x, 0.0, view.size.x) + std::clamp(max.x, 0.0, view.size.x)) / 2;
    const double lowest = view.size.y - fromEdge - size.height();
    const double y = std::clamp(max.y + underWindow, fromEdge, std::max(fromEdge, lowest));
    return {QPointF(x - size.width() / 2, y), size};
}

void paintOffer(QPainter& painter, const QRectF& place, const std::optional<Pointer>& pointer,
                const Look& look, const QColor& ground)
{
    const bool hovered = pointer && place.contains(pointer->screen.x, pointer->screen.y);
    painter.setFont(QGuiApplication::font());
    painter.setPen(QPen(look.accent, 1));
    painter.setBrush(hovered ? look.accent : ground);
    painter.drawRoundedRect(place, 4, 4);
    painter.setPen(hovered ? look.onAccent : look.accent);
    painter.drawText(place, Qt::AlignCenter, text());
}

} // namespace ui
