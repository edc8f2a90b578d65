// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/window_overlay.h"

#include "app/base/numbers.h"
#include "app/view/place.h"
#include "ui/canvas/window_offer.h"

#include <glm/common.hpp>

#include <algorithm>
#include <map>
#include <utility>

namespace ui {
namespace {

constexpr double outline = 1.5, outlineHovered = 2.5, casing = 1; // pixels
constexpr double handleSize = 9, labelGap = 13;

// The window in screen coordinates, limited to the visible range, because painters fail with
// coordinates like 1e9.
QRectF onScreen(const app::View& view, const clipping::Window& window)
{
    const app::Point room(64), least = -room, most = view.size + room;
    const app::Point min = glm::clamp(view.toScreen(window.min), least, most);
    const app::Point max = glm::clamp(view.toScreen(window.max), least, most);
    return {QPointF(min.x, min.y), QPointF(max.x, max.y)};
}

QRectF rectangleOnScreen(const Controller& controller)
{
    return onScreen(controller.view(), controller.window());
}

// Windows that add are solid; the other operations have different dashes.
Qt::PenStyle dashesOf(app::WindowOperation operation)
{
    static const std::map<app::WindowOperation, Qt::PenStyle> styles{
        {app::WindowOperation::Add, Qt::SolidLine},
        {app::WindowOperation::CutOut, Qt::DashLine},
        {app::WindowOperation::Intersect, Qt::DotLine}};
    return styles.at(operation);
}

// Paints the drawing's other windows with thin lines.
void paintOthers(QPainter& painter, const Controller& controller)
{
    painter.setBrush(Qt::NoBrush);
    bool first = true;
    for (const app::ClipRegion::Step& step : controller.session().region().steps) {
        if (std::exchange(first, false))
            continue; // this window is painted with handles
        painter.setPen(QPen(controller.look().accent, 1, dashesOf(step.operation)));
        painter.drawRect(onScreen(controller.view(), step.box));
    }
}

void paintHandles(QPainter& painter, const Controller& controller, const Look& look)
{
    painter.setPen(QPen(look.accent, outline));
    for (const auto& [handle, at] : app::placedHandles(controller.window(), controller.view())) {
        const bool hovered = controller.tool().hoveredHandle() == handle;
        painter.setBrush(hovered ? look.accent : controller.pageColour());
        painter.drawRect(QRectF(at.x - handleSize / 2 + 0.5, at.y - handleSize / 2 + 0.5,
                                handleSize - 1, handleSize - 1));
    }
}

QString labelText(const Controller& controller)
{
    const app::Page& page = controller.session().now().page();
    const app::Unit unit = controller.session().display().unit;
    const clipping::Window window = controller.window();
    if (controller.session().preview().drag != app::Preview::Drag::Moving)
        return app::sizeText(window.max - window.min, unit, page.millimetresPerUnit());
    const app::Point place = window.min - app::originOf(page, unit);
    return QStringLiteral("%1, %2").arg(app::lengthNumber(place.x, unit, page.millimetresPerUnit()),
                                        app::lengthText(place.y, unit, page.millimetresPerUnit()));
}

QFont labelFont(QFont font)
{
    font.setWeight(QFont::DemiBold);
    font.setPointSizeF(font.pointSizeF() * 0.92);
    return font;
}

QRectF labelPlace(const Controller& controller, const QRectF& window, const QFont& font)
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

void paintLabel(QPainter& painter, const Controller& controller, const QRectF& window)
{
    const Look& look = controller.look();
    painter.setFont(labelFont(painter.font()));
    const QRectF label = labelPlace(controller, window, painter.font());
    painter.setPen(Qt::NoPen);
    painter.setBrush(look.accent);
    painter.drawRoundedRect(label, 3, 3);
    painter.setPen(look.onAccent);
    painter.drawText(label, Qt::AlignCenter, labelText(controller));
}

// Whether the window has handles and a label: only in the active pane, if its outline is visible.
bool isFurnished(const Controller& controller, const Pane& pane, const QRectF& window)
{
    const QRectF seen(0, 0, controller.view().size.x, controller.view().size.y);
    return pane.active && controller.tool().showsHandles() && seen.intersects(window)
           && !window.contains(seen);
}

} // namespace

void paintWindow(QPainter& painter, const Controller& controller, const Pane& pane)
{
    if (!controller.clipWindow()) {
        if (const QRectF place = controller.offeredHandle(); pane.active && !place.isEmpty())
            paintOffer(painter, place, controller.pointer(), controller.look(),
                       controller.pageColour());
        return;
    }
    paintOthers(painter, controller);
    const Look& look = controller.look();
    const QRectF window = rectangleOnScreen(controller);
    const bool hovered = controller.tool().hoveredHandle() == app::Handle{};
    const double width =
        (hovered ? outlineHovered : outline) * (controller.session().display().presenting ? 2 : 1);
    QPen pen(controller.pageColour(), width + 2 * casing, Qt::SolidLine, Qt::FlatCap,
             Qt::MiterJoin);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(pen);
    painter.drawRect(window);
    pen.setColor(look.accent);
    pen.setWidthF(width);
    painter.setPen(pen);
    painter.drawRect(window);
    if (!isFurnished(controller, pane, window))
        return;
    paintHandles(painter, controller, look);
    paintLabel(painter, controller, window);
}

std::vector<QRectF> windowFurniture(const Controller& controller, const Pane& pane,
                                    const QFont& font)
{
    if (!controller.clipWindow())
        return {controller.offeredHandle()};
    const QRectF window = rectangleOnScreen(controller);
    std::vector<QRectF> places{QRectF(window.topLeft(), QSizeF(window.width(), 0)),
                               QRectF(window.bottomLeft(), QSizeF(window.width(), 0)),
                               QRectF(window.topLeft(), QSizeF(0, window.height())),
                               QRectF(window.topRight(), QSizeF(0, window.height()))};
    for (QRectF& edge : places)
        edge.adjust(-outline, -outline, outline, outline);
    if (!isFurnished(controller, pane, window))
        return places;
    for (const auto& [handle, at] : app::placedHandles(controller.window(), controller.view()))
        places.push_back(
            QRectF(at.x - handleSize / 2, at.y - handleSize / 2, handleSize, handleSize));
    places.push_back(labelPlace(controller, window, labelFont(font)));
    return places;
}

} // namespace ui
