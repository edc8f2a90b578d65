// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/window_overlay.h"

#include "app/view/numbers.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>

namespace ui {
namespace {

constexpr double outline = 1.5, outlineLit = 2.5, casing = 1; // pixels
constexpr double handle = 9, labelGap = 13;

// The window on the screen, no farther out than its lines could be seen: no painter likes 1e9.
QRectF rectangleOnScreen(const Controller& controller)
{
    const app::View& view = controller.view();
    const clipping::Window window = controller.window();
    const app::Point room(64), least = -room, most = view.size + room;
    const app::Point min = glm::clamp(view.toScreen(window.min), least, most);
    const app::Point max = glm::clamp(view.toScreen(window.max), least, most);
    return {QPointF(min.x, min.y), QPointF(max.x, max.y)};
}

void paintHandles(QPainter& painter, const Controller& controller, const Look& look)
{
    painter.setPen(QPen(look.accent, outline));
    for (const auto& [grip, at] : app::placedGrips(controller.window(), controller.view())) {
        const bool lit = controller.tool().litGrip() == grip;
        painter.setBrush(lit ? look.accent : controller.pageColour());
        painter.drawRect(
            QRectF(at.x - handle / 2 + 0.5, at.y - handle / 2 + 0.5, handle - 1, handle - 1));
    }
}

QString labelText(const Controller& controller)
{
    const app::Page& page = controller.session().sheet().page;
    const app::Unit unit = controller.session().display().unit;
    const clipping::Window window = controller.window();
    if (controller.tool().windowGesture() != Tool::WindowGesture::Moving)
        return app::sizeText(window.max - window.min, unit, page.millimetresPerUnit());
    return QStringLiteral("%1, %2").arg(
        app::lengthNumber(window.min.x, unit, page.millimetresPerUnit()),
        app::lengthText(window.min.y, unit, page.millimetresPerUnit()));
}

void paintLabel(QPainter& painter, const Controller& controller, const QRectF& window)
{
    const Look& look = controller.look();
    QFont font = painter.font();
    font.setWeight(QFont::DemiBold);
    font.setPointSizeF(font.pointSizeF() * 0.92);
    painter.setFont(font);
    const QString text = labelText(controller);
    const QRectF size = QFontMetricsF(font).boundingRect(text);
    QRectF label(0, 0, size.width() + 16, size.height() + 4);
    label.moveCenter({window.center().x(), 0});
    label.moveTop(window.bottom() + labelGap);
    const app::Point room = controller.view().size;
    if (label.bottom() > room.y - 4)
        label.moveBottom(std::min(window.bottom() - labelGap, room.y - 4));
    label.moveLeft(std::clamp(label.left(), 4.0, std::max(4.0, room.x - 4 - label.width())));
    painter.setPen(Qt::NoPen);
    painter.setBrush(look.accent);
    painter.drawRoundedRect(label, 3, 3);
    painter.setPen(look.onAccent);
    painter.drawText(label, Qt::AlignCenter, text);
}

} // namespace

void paintWindow(QPainter& painter, const Controller& controller, const Pane& pane)
{
    const Look& look = controller.look();
    const QRectF window = rectangleOnScreen(controller);
    const bool lit = controller.tool().litGrip() == app::Grip{};
    const double width =
        (lit ? outlineLit : outline) * (controller.session().display().presenting ? 2 : 1);
    QPen pen(controller.pageColour(), width + 2 * casing, Qt::SolidLine, Qt::FlatCap,
             Qt::MiterJoin);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(pen);
    painter.drawRect(window);
    pen.setColor(look.accent);
    pen.setWidthF(width);
    painter.setPen(pen);
    painter.drawRect(window);
    const QRectF seen(0, 0, controller.view().size.x, controller.view().size.y);
    const bool edgeSeen = seen.intersects(window) && !window.contains(seen);
    if (!pane.active || !controller.tool().showsGrips() || !edgeSeen)
        return;
    paintHandles(painter, controller, look);
    paintLabel(painter, controller, window);
}

// Columns and rows from the upper left of the screen. The outcode is written as in the paper: top,
// bottom, right, left, where "top" is the edge that is on top on the screen.
void paintRegions(QPainter& painter, const Controller& controller)
{
    const Look& look = controller.look();
    const QRectF window = rectangleOnScreen(controller);
    const app::Point size = controller.view().size;
    const std::array xs{0.0, window.left(), window.right(), size.x};
    const std::array ys{0.0, window.top(), window.bottom(), size.y};
    painter.setPen(QPen(look.accent, 0, Qt::DashLine));
    for (int i = 1; i < 3; ++i) {
        painter.drawLine(QPointF(xs[i], 0), QPointF(xs[i], size.y));
        painter.drawLine(QPointF(0, ys[i]), QPointF(size.x, ys[i]));
    }
    QFont font = painter.font();
    font.setWeight(QFont::DemiBold);
    font.setPointSizeF(font.pointSizeF() * 1.3);
    painter.setFont(font);
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) {
            const QRectF cell(QPointF(xs[column], ys[row]), QPointF(xs[column + 1], ys[row + 1]));
            const QString code = QStringLiteral("%1%2%3%4")
                                     .arg(row == 0)
                                     .arg(row == 2)
                                     .arg(column == 2)
                                     .arg(column == 0);
            const QRectF text = QFontMetricsF(font).boundingRect(code).adjusted(-6, -2, 6, 2);
            if (cell.width() < text.width() || cell.height() < text.height())
                continue;
            QRectF ground = text;
            ground.moveCenter(cell.center());
            QColor veil = controller.pageColour();
            veil.setAlphaF(0.85F);
            painter.fillRect(ground, veil);
            painter.setPen(look.accent);
            painter.drawText(ground, Qt::AlignCenter, code);
        }
}

} // namespace ui
