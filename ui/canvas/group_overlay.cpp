// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/group_overlay.h"

#include "app/scene/bounds.h"
#include "app/session/units.h"

#include <glm/common.hpp>

namespace ui {
namespace {

constexpr double aroundGroup = 10, labelHeight = 18, labelPadding = 6; // pixels
constexpr float pale = 0.55F; // opacity of the veil outside

// Limited to the surroundings of the view: painters fail with coordinates like 1e9.
QRectF frameOf(const clipping::Window& bounds, const app::View& view, double around)
{
    const app::Point most = view.size + 64.0, least(-64);
    const app::Point min = glm::clamp(view.toScreen(bounds.min) - around, least, most);
    const app::Point max = glm::clamp(view.toScreen(bounds.max) + around, least, most);
    return {QPointF(min.x, min.y), QPointF(max.x, max.y)};
}

std::optional<clipping::Window> boundsOf(const app::Session& session, app::ContainerId group)
{
    return app::boundsOf(session.scene.lines(),
                         app::ObjectRanges(session.now().containers().rangeOf(group)));
}

void paintName(QPainter& painter, const Look& look, const QRectF& frame, const QString& name)
{
    const QFontMetricsF metrics(painter.font());
    const double width = metrics.horizontalAdvance(name) + 2 * labelPadding;
    const double top = std::max(0.0, frame.top() - labelHeight);
    const QRectF label(std::max(0.0, frame.left()), top, width, labelHeight);
    painter.fillRect(label, look.selection);
    painter.setPen(look.paper);
    painter.drawText(label, Qt::AlignCenter, name);
}

} // namespace

void paintEnteredGroup(QPainter& painter, const Controller& controller)
{
    const app::Session& session = controller.session();
    const app::ContainerId group = session.entered.id();
    if (group == 0)
        return;
    const auto bounds = boundsOf(session, group);
    if (!bounds)
        return;
    const app::View& view = controller.view();
    const QRectF frame = frameOf(*bounds, view, aroundGroup);
    painter.save();
    QPainterPath outside;
    outside.addRect(QRectF(0, 0, view.size.x, view.size.y));
    outside.addRect(frame);
    QColor veil = controller.pageColour();
    veil.setAlphaF(pale);
    painter.fillPath(outside, veil);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(controller.paperLook().selection, 1, Qt::DashLine));
    painter.drawRect(frame);
    paintName(painter, controller.paperLook(), frame,
              app::groupName(session.now().containers()[group]));
    painter.restore();
}

void paintHoveredGroup(QPainter& painter, const Controller& controller, std::size_t segment)
{
    const app::Session& session = controller.session();
    const app::ContainerId group = app::groupAt(session, session.scene.lines().objectOf(segment));
    const auto bounds = group == 0 ? std::nullopt : boundsOf(session, group);
    if (!bounds || !controller.toolInfo().arranges()) // other tools choose single objects
        return;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(controller.paperLook().selection, 1));
    painter.drawRect(frameOf(*bounds, controller.view(), aroundGroup / 2));
}

} // namespace ui
