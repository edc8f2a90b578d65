// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/grid_paint.h"

#include <glm/common.hpp>

#include <cmath>

namespace ui {
namespace {

void paintGridLine(QPainter& painter, const QLineF& line, const QColor& colour)
{
    const double ratio = painter.device()->devicePixelRatioF(), pixel = 1 / ratio;
    const auto snapped = [&](double v) { return std::floor(v * ratio) / ratio; };
    if (line.x1() == line.x2())
        painter.fillRect(QRectF(snapped(line.x1()), line.y1(), pixel, line.dy()).normalized(),
                         colour);
    else if (line.y1() == line.y2())
        painter.fillRect(QRectF(line.x1(), snapped(line.y1()), line.dx(), pixel).normalized(),
                         colour);
    else {
        painter.setPen(QPen(colour, pixel));
        painter.drawLine(line);
    }
}

void paintLines(QPainter& painter, const Controller& controller, const app::Grid& grid,
                const clipping::Window& seen)
{
    const Look& look = controller.paperLook();
    const auto lines =
        app::gridLines(grid, controller.session().now().page(), controller.view().zoom, seen);
    for (const bool major : {false, true}) // major lines over the others
        for (const app::GridLine& line : lines)
            if (line.major == major)
                paintGridLine(painter,
                              {controller.bench().onScreen(line.line.a),
                               controller.bench().onScreen(line.line.b)},
                              major ? look.gridMajor : look.grid);
}

void paintDots(QPainter& painter, const Controller& controller, const app::Grid& grid,
               const clipping::Window& seen)
{
    const QColor colour = controller.paperLook().border;
    for (const app::Point& dot :
         app::gridDots(grid, controller.session().now().page(), controller.view().zoom, seen)) {
        const QPointF at = controller.bench().onScreen(dot);
        painter.fillRect(QRectF(std::round(at.x()) - 0.5, std::round(at.y()) - 0.5, 1.5, 1.5),
                         colour);
    }
}

} // namespace

void paintGrid(QPainter& painter, const Controller& controller)
{
    const app::Grid& grid = controller.session().display().grid;
    const clipping::Window page = controller.session().now().page().rectangle();
    const clipping::Window view = controller.view().visible();
    const clipping::Window seen{glm::max(page.min, view.min), glm::min(page.max, view.max)};
    if (!grid.shown || seen.min.x >= seen.max.x || seen.min.y >= seen.max.y)
        return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing, grid.pattern != app::Grid::Pattern::Square);
    grid.marks == app::Grid::Marks::Dots ? paintDots(painter, controller, grid, seen)
                                         : paintLines(painter, controller, grid, seen);
    painter.restore();
}

} // namespace ui
