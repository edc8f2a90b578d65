// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/cost_map_view.h"

#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/chart_view.h"
#include "ui/widgets/spoken_role.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

constexpr int mapMargin = 3, aboveLegend = 6;
constexpr double cellPixels = 2;
constexpr double usualLegend = 32;   // pixels
constexpr double keyStep = 1. / 200; // fraction of the area's width
constexpr double far = 10;           // factor with Shift

} // namespace

CostMapView::CostMapView(QWidget* parent)
    : QWidget(parent), plan_(app::usualCostPlan({{0, 0}, {1, 1}}))
{
    setMouseTracking(true);
    setSpokenRole(*this, QAccessible::Graphic);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::CrossCursor);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(Text::tr("Cost map"));
}

void CostMapView::show(const app::CostPlan& plan, const app::CostMap* map)
{
    plan_ = plan;
    if (map)
        map_ = *map;
    else
        map_.reset();
    update();
}

app::CostMapLook CostMapView::look() const
{
    app::CostMapLook look{chartLookOf(*this), lookOf(palette()).accent};
    look.chart.font = captionFont(font());
    return look;
}

QRectF CostMapView::room(double legend) const
{
    return rect().adjusted(mapMargin, mapMargin, -mapMargin,
                           -int(legend) - aboveLegend - mapMargin);
}

QRectF CostMapView::place() const
{
    const double legend =
        map_ ? app::legendHeight(*map_, width() - 2 * mapMargin, look()) : usualLegend;
    return app::mapPlace(plan_, room(legend));
}

/// The same whichever map is shown until then, or none.
QSize CostMapView::cells(const app::CostPlan& plan) const
{
    const QSizeF size = app::mapPlace(plan, room(usualLegend)).size() / cellPixels;
    return size.toSize().expandedTo({24, 18});
}

QSize CostMapView::sizeHint() const { return {520, 440}; }
QSize CostMapView::minimumSizeHint() const { return {200, 160}; }

void CostMapView::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const QRectF map = place();
    app::CostMap shown = map_.value_or(app::CostMap{plan_});
    shown.plan.fixed = plan_.fixed; // the dragged position, even if the map is older
    shown.plan.window = plan_.window;
    const bool fine = shown.plan == plan_;
    const auto labels = fine && !dragging_ ? app::RegionLabels::Shown : app::RegionLabels::None;
    painter.fillRect(map, lookOf(palette()).base);
    app::paintMap(painter, map, shown, look(), labels);
    app::paintLegend(
        painter, QRectF(mapMargin, map.bottom() + aboveLegend, width() - 2 * mapMargin, height()),
        shown, look());
    if (!hasFocus())
        return;
    painter.setPen(QPen(lookOf(palette()).selection, 2));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(map.adjusted(-1, -1, 1, 1));
}

void CostMapView::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    emit resized();
}

void CostMapView::moveTo(const QPointF& pixel)
{
    const app::Point point = app::onPlane(plan_, place(), pixel);
    emit fixedEndMoved(glm::clamp(point, plan_.area.min, plan_.area.max));
}

void CostMapView::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton || !place().contains(event->position()))
        return;
    dragging_ = true;
    moveTo(event->position());
}

void CostMapView::mouseMoveEvent(QMouseEvent* event)
{
    if (dragging_)
        moveTo(event->position());
    const bool within = place().contains(event->position());
    emit pointed(within ? std::optional(app::onPlane(plan_, place(), event->position()))
                        : std::nullopt);
}

void CostMapView::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton || !dragging_)
        return;
    dragging_ = false;
    emit dropped();
}

void CostMapView::leaveEvent(QEvent*) { emit pointed(std::nullopt); }

void CostMapView::keyPressEvent(QKeyEvent* event)
{
    app::Point step(0);
    switch (event->key()) {
    case Qt::Key_Left:
        step.x = -1;
        break;
    case Qt::Key_Right:
        step.x = 1;
        break;
    case Qt::Key_Up:
        step.y = -1;
        break;
    case Qt::Key_Down:
        step.y = 1;
        break;
    default:
        return QWidget::keyPressEvent(event);
    }
    const double pixels =
        place().width() * keyStep * (event->modifiers() & Qt::ShiftModifier ? far : 1);
    const QPointF now = app::onMap(plan_, place(), plan_.fixed);
    moveTo(now + QPointF(step.x, step.y) * pixels);
}

void CostMapView::focusInEvent(QFocusEvent* event)
{
    QWidget::focusInEvent(event);
    update();
}

void CostMapView::focusOutEvent(QFocusEvent* event)
{
    QWidget::focusOutEvent(event);
    update();
}

} // namespace ui

#include "moc_cost_map_view.cpp"
