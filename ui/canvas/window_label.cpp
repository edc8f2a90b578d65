// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/window_label.h"

#include "app/base/numbers.h"
#include "app/view/ruler.h"

#include <glm/trigonometric.hpp>

#include <algorithm>

namespace ui {
namespace {

constexpr double labelGap = 13; // pixels

QString labelText(const Controller& controller)
{
    const app::Page& page = controller.session().now().page();
    const app::Unit unit = controller.session().display().unit;
    const app::WindowFrame& frame = *controller.session().windowFrame();
    const app::Preview::Drag drag = controller.session().preview().drag;
    if (drag == app::Preview::Drag::Rotating) // by how much, counterclockwise
        return QStringLiteral("%1°").arg(
            app::numberText(-glm::degrees(controller.session().preview().angle), 1));
    if (drag != app::Preview::Drag::Moving)
        return app::sizeText(frame.box.max - frame.box.min, unit, page.realMillimetresPerUnit());
    const app::Point place = frame.box.min - app::originOf(page, unit);
    return QStringLiteral("%1, %2").arg(
        app::lengthNumber(place.x, unit, page.realMillimetresPerUnit()),
        app::lengthText(place.y, unit, page.realMillimetresPerUnit()));
}

QFont labelFont(QFont font)
{
    font.setWeight(QFont::DemiBold);
    font.setPointSizeF(font.pointSizeF() * 0.92);
    return font;
}

/// `font` is that of the label.
QRectF placeOfLabel(const Controller& controller, const QRectF& window, const QFont& font)
{
    const QRectF size = QFontMetricsF(font).boundingRect(labelText(controller));
    QRectF label(0, 0, size.width() + 16, size.height() + 4);
    label.moveCenter({window.center().x(), 0});
    label.moveTop(window.bottom() + labelGap);
    const app::Point room = controller.view().size;
    if (label.bottom() > room.y - 4)
        label.moveBottom(std::min(window.bottom() - labelGap, room.y - 4));
    label.moveLeft(std::clamp(label.left(), 4.0, std::max(4.0, room.x - 4 - label.width())));
    return label;
}

} // namespace

QRectF windowLabelPlace(const Controller& controller, const QRectF& window, const QFont& font)
{
    return placeOfLabel(controller, window, labelFont(font));
}

void paintWindowLabel(QPainter& painter, const Controller& controller, const QRectF& window)
{
    const Look& look = controller.paperLook();
    painter.setFont(labelFont(painter.font()));
    const QRectF label = placeOfLabel(controller, window, painter.font());
    painter.setPen(Qt::NoPen);
    painter.setBrush(look.accent);
    painter.drawRoundedRect(label, 3, 3);
    painter.setPen(look.onAccent);
    painter.drawText(label, Qt::AlignCenter, labelText(controller));
}

} // namespace ui
