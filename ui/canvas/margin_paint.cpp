// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/margin_paint.h"

#include "app/session/page_steps.h"

#include <QPainterPath>

#include <glm/common.hpp>

namespace ui {
namespace {

constexpr double groundInLight = 0.07, groundInDark = 0.10;

/// Painters fail with coordinates like 1e9.
QRectF marginRect(const app::View& view, const clipping::Window& box)
{
    const app::Point least(-16), most = view.size + 16.0;
    const app::Point min = glm::clamp(view.toScreen(box.min), least, most);
    const app::Point max = glm::clamp(view.toScreen(box.max), least, most);
    return {QPointF(min.x, min.y), QPointF(max.x, max.y)};
}

} // namespace

void paintMargins(QPainter& painter, const Controller& controller)
{
    const app::Page& page = controller.session().now().page();
    if (!page.margins.shown)
        return;
    const Look& look = controller.paperLook();
    const QRectF inside = marginRect(controller.view(), app::insideOf(page));
    QPainterPath ground;
    ground.setFillRule(Qt::OddEvenFill);
    ground.addRect(marginRect(controller.view(), page.rectangle()));
    ground.addRect(inside);
    QColor colour = look.guide;
    colour.setAlphaF(float(look.dark ? groundInDark : groundInLight));
    painter.fillPath(ground, colour);
    painter.save();
    painter.setPen(QPen(look.guide, 1, Qt::DashLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(inside);
    painter.restore();
}

} // namespace ui
