// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/chart_view.h"

#include "app/charts/chart_layout.h"
#include "app/charts/chart_paint.h"
#include "ui/look/text.h"
#include "ui/widgets/algorithm_marker.h"
#include "ui/widgets/spoken_role.h"

#include <QContextMenuEvent>
#include <QFontInfo>
#include <QHelpEvent>
#include <QMenu>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

constexpr int margin = 8, usualWidth = 560, leastWidth = 200;

} // namespace

app::ChartLook chartLookOf(const QWidget& widget)
{
    const Look& look = lookOf(widget.palette());
    QFont font = widget.font();
    font.setPixelSize(QFontInfo(font).pixelSize());
    return {groundOf(widget.palette()),
            widget.palette().color(widget.backgroundRole()),
            look.text,
            look.muted,
            look.rule,
            font};
}

ChartView::ChartView(QWidget* parent) : QWidget(parent), chart_{.key = {}, .title = {}, .rows = {}}
{
    setMouseTracking(true);
    setSpokenRole(*this, QAccessible::Chart);
    setFocusPolicy(Qt::StrongFocus);
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
}

void ChartView::setChart(app::Chart chart)
{
    chart_ = std::move(chart);
    current_.reset();
    setAccessibleName(chart_.title);
    setAccessibleDescription(textOf(chart_));
    updateGeometry();
    update();
}

QSize ChartView::sizeHint() const { return {usualWidth, heightForWidth(usualWidth)}; }

QSize ChartView::minimumSizeHint() const
{
    const int inner = std::max(width(), leastWidth) - 2 * margin;
    return {leastWidth, int(leastHeight(chart_, inner, chartLookOf(*this))) + 2 * margin};
}

int ChartView::heightForWidth(int width) const
{
    const int inner = std::min(width, maximumWidth()) - 2 * margin;
    return int(std::ceil(naturalHeight(chart_, inner, chartLookOf(*this)))) + 2 * margin;
}

QRectF ChartView::area() const { return rect().adjusted(margin, margin, -margin, -margin); }

void ChartView::light(std::optional<std::size_t> row)
{
    if (row == current_)
        return;
    current_ = row;
    update();
}

bool ChartView::event(QEvent* event)
{
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    if (const auto row = rowAt(help->pos(), area(), chart_, chartLookOf(*this)))
        QToolTip::showText(help->globalPos(), chart_.rows[*row].detail, this);
    else
        QToolTip::hideText();
    return true;
}

void ChartView::paintEvent(QPaintEvent*)
{
    const Look& look = lookOf(palette());
    const app::ChartLook chartLook = chartLookOf(*this);
    QPainter painter(this);
    if (current_ && *current_ < chart_.rows.size())
        painter.fillRect(
            layoutOf(chart_, area(), chartLook).rows[*current_].adjusted(-margin, 0, margin, 0),
            hasFocus() ? look.tint : look.hover);
    paint(painter, area(), chart_, chartLook);
    if (!hasFocus())
        return;
    painter.setPen(QPen(look.selection, 2));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(rect().adjusted(1, 1, -1, -1));
}

void ChartView::mouseMoveEvent(QMouseEvent* event)
{
    light(rowAt(event->position(), area(), chart_, chartLookOf(*this)));
}

void ChartView::leaveEvent(QEvent*) { light(std::nullopt); }

void ChartView::keyPressEvent(QKeyEvent* event)
{
    const bool down = event->key() == Qt::Key_Down, up = event->key() == Qt::Key_Up;
    if ((!down && !up) || chart_.rows.empty())
        return QWidget::keyPressEvent(event);
    const std::size_t last = chart_.rows.size() - 1;
    if (!current_)
        light(down ? 0 : last);
    else
        light(down ? std::min(*current_ + 1, last)
                   : *current_ - std::min<std::size_t>(*current_, 1));
    tellRow();
}

/// Shows the row's tooltip for keyboard users and describes the row for screen readers.
void ChartView::tellRow()
{
    const QRect row = layoutOf(chart_, area(), chartLookOf(*this)).rows[*current_].toRect();
    const QString& detail = chart_.rows[*current_].detail;
    setAccessibleDescription(detail);
    QToolTip::showText(mapToGlobal(row.bottomLeft()), detail, this);
}

void ChartView::focusInEvent(QFocusEvent* event)
{
    QWidget::focusInEvent(event);
    update();
}

void ChartView::focusOutEvent(QFocusEvent* event)
{
    QWidget::focusOutEvent(event);
    setAccessibleDescription(textOf(chart_));
    update();
}

void ChartView::contextMenuEvent(QContextMenuEvent* event)
{
    QMenu menu(this);
    connect(menu.addAction(Text::tr("Export chart…")), &QAction::triggered, this,
            &ChartView::exportWanted);
    menu.exec(event->globalPos());
}

} // namespace ui

#include "moc_chart_view.cpp"
