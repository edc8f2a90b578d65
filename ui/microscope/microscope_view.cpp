// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/microscope/microscope_view.h"

#include "app/teaching/figure.h"
#include "app/teaching/figure_text.h"
#include "app/teaching/near_frame.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/algorithm_marker.h"
#include "ui/widgets/spoken_role.h"

#include <QFontInfo>
#include <QMouseEvent>
#include <QPainter>
#include <QScopedValueRollback>

#include <cmath>
#include <utility>

namespace ui {

namespace {

constexpr double ringRadius = 9; // pixels

} // namespace

MicroscopeView::MicroscopeView(app::Microscope& microscope, QWidget* parent)
    : QWidget(parent), microscope_(microscope)
{
    setSpokenRole(*this, QAccessible::Canvas);
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAccessibleName(Text::tr("Line under the microscope"));
    setAttribute(Qt::WA_OpaquePaintEvent);
    connect(&microscope, &app::Microscope::stepChanged, this, [this] {
        describe();
        update();
    });
    connect(&microscope, &app::Microscope::tracedLineChanged, this, &MicroscopeView::follow);
    connect(&microscope, &app::Microscope::openChanged, this, &MicroscopeView::fit);
    describe();
}

/// A line that another part of the program puts under the microscope is fitted, also in a view that
/// was zoomed; one that a hand changes here, or whose ends are exchanged, stays where it is.
void MicroscopeView::follow()
{
    const clipping::Segment& line = microscope_.tracedLine().line;
    const clipping::Segment before = std::exchange(line_, line);
    const bool isSame = before == line || before == clipping::Segment{line.b, line.a};
    const bool isNew = !isSame && !movesEnd_;
    if (isNew && !drag_)
        fit();
    else if (fitted_ && !drag_ && !chosen_)
        refit();
    frame_.y = microscope_.tracedLine().y;
    describe();
    update();
    emit reframed();
}

/// For screen readers: what an end that is chosen can do, otherwise the figure in words.
void MicroscopeView::describe()
{
    setAccessibleDescription(chosen_
                                 ? hint()
                                 : app::figureText(microscope_.tracedLine(),
                                                   microscope_.narration(), microscope_.step()));
}

void MicroscopeView::refit()
{
    QFont body = font();
    body.setPixelSize(QFontInfo(body).pixelSize());
    auto discs = std::move(frame_.discs);
    frame_ = app::nearFrame(microscope_.tracedLine(), QSizeF(size()), body);
    frame_.reserved = reserved_;
    frame_.discs = std::move(discs);
    frame_.countsSteps = countsSteps_;
    update();
    emit framed();
}

void MicroscopeView::reserve(const QRectF& place)
{
    reserved_ = frame_.reserved = place;
    update();
    emit reframed();
}

void MicroscopeView::leaveFree(std::vector<QRectF> discs)
{
    if (discs == frame_.discs)
        return;
    frame_.discs = std::move(discs);
    update();
}

void MicroscopeView::countSteps(bool counted)
{
    countsSteps_ = frame_.countsSteps = counted;
    update();
}

void MicroscopeView::fit()
{
    fitted_ = true;
    refit();
}

/// Fits everything into the view if an end was moved out of it.
void MicroscopeView::keepInSight()
{
    const auto& line = microscope_.tracedLine().line;
    if (!frame_.shows(line.a) || !frame_.shows(line.b))
        fit();
}

void MicroscopeView::moveEnd(LineEnd end, const app::Point& point)
{
    app::TracedLine tracedLine = microscope_.tracedLine();
    tracedLine.line = withEnd(tracedLine.line, end, point);
    const QScopedValueRollback moves(movesEnd_, true);
    if (tracedLine != microscope_.tracedLine())
        microscope_.setTracedLine(tracedLine);
}

void MicroscopeView::choose(std::optional<LineEnd> end)
{
    if (end == chosen_)
        return;
    chosen_ = end;
    describe();
    emit hinted(hint());
    update();
}

QString MicroscopeView::hint() const
{
    if (chosen_)
        return Text::tr(
                   "End %1: arrow keys move it, with Shift ten times as far. After Esc they change "
                   "the step again.")
            .arg(*chosen_ == LineEnd::One ? 1 : 2);
    return Text::tr("Drag an end of the line: the whole trace follows. Ctrl suspends snapping.");
}

void MicroscopeView::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    app::paintStep(painter, {microscope_.tracedLine(), microscope_.narration(), microscope_.step()},
                   frame_, app::figureColours(groundOf(palette())));
    painter.setRenderHint(QPainter::Antialiasing);
    if (hovered_)
        paintRing(painter, *hovered_, 1.5);
    if (chosen_)
        paintRing(painter, *chosen_, 2.5);
    if (hasFocus() && ring_) {
        painter.setPen(QPen(lookOf(palette()).selection, 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(1, 1, -1, -1));
    }
}

void MicroscopeView::paintRing(QPainter& painter, LineEnd end, double width) const
{
    const app::Point& point = endOf(microscope_.tracedLine().line, end);
    if (!frame_.shows(point))
        return;
    painter.setPen(QPen(lookOf(palette()).selection, width));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(frame_.at(point), ringRadius * frame_.unit(), ringRadius * frame_.unit());
}

void MicroscopeView::resizeEvent(QResizeEvent*) { fit(); }

void MicroscopeView::hover(const QPointF& place)
{
    const auto end = endAt(frame_, microscope_.tracedLine().line, place);
    if (end == hovered_)
        return;
    hovered_ = end;
    setCursor(end ? Qt::SizeAllCursor : Qt::ArrowCursor);
    update();
}

void MicroscopeView::mousePressEvent(QMouseEvent* event)
{
    const auto& line = microscope_.tracedLine().line;
    const QPointF place = event->position();
    hover(place);
    if (event->button() == Qt::MiddleButton || (event->button() == Qt::LeftButton && !hovered_)) {
        drag_ = Drag{{}, line, place};
        setCursor(Qt::ClosedHandCursor);
    } else if (event->button() == Qt::LeftButton) {
        drag_ = Drag{hovered_, line, frame_.at(endOf(line, *hovered_)) - place};
    }
    if (hovered_ != chosen_)
        choose({});
}

void MicroscopeView::mouseMoveEvent(QMouseEvent* event)
{
    const QPointF place = event->position();
    if (!drag_) {
        hover(place);
    } else if (drag_->end) {
        const bool free = event->modifiers() & Qt::ControlModifier;
        moveEnd(*drag_->end,
                handPoint(frame_, microscope_.tracedLine().window, place + drag_->handle,
                          free ? Snapping::Off : Snapping::ToWindow));
    } else {
        pan(place - drag_->handle);
        drag_->handle = place;
    }
    emit pointerMoved(frame_.pointAt(place));
}

void MicroscopeView::mouseReleaseEvent(QMouseEvent* event)
{
    const bool moved = drag_ && drag_->end;
    drag_.reset();
    if (moved)
        keepInSight();
    hovered_.reset();
    setCursor(Qt::ArrowCursor);
    hover(event->position());
    if (moved)
        emit framed();
}

void MicroscopeView::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton
        && !endAt(frame_, microscope_.tracedLine().line, event->position()))
        fit();
}

void MicroscopeView::cancelDrag()
{
    const auto drag = std::exchange(drag_, std::nullopt);
    if (!drag || !drag->end)
        return;
    moveEnd(*drag->end, endOf(drag->before, *drag->end));
}

void MicroscopeView::pan(const QPointF& by)
{
    const app::Point from = frame_.pointAt({0, 0}), to = frame_.pointAt(by);
    frame_.seen.min += from - to;
    frame_.seen.max += from - to;
    fitted_ = fitted_ && by.isNull();
    update();
    emit framed();
}

void MicroscopeView::zoomAt(const QPointF& place, double factor)
{
    const app::Point fixed = frame_.pointAt(place);
    const clipping::Window seen{fixed + (frame_.seen.min - fixed) / factor,
                                fixed + (frame_.seen.max - fixed) / factor};
    const double size = seen.max.x - seen.min.x;
    const double far = std::max({std::abs(seen.min.x), std::abs(seen.max.x), 1e-290});
    // Too small: neighbouring doubles, or not finite.
    if (!(size > far * 1e-12) || !std::isfinite(size))
        return;
    frame_.seen = seen;
    fitted_ = false;
    update();
    emit framed();
}

void MicroscopeView::zoomBy(double factor) { zoomAt(QRectF(rect()).center(), factor); }

void MicroscopeView::wheelEvent(QWheelEvent* event)
{
    constexpr double perNotch = 1.25, notch = 120;
    const int turned = event->angleDelta().y();
    if (turned != 0)
        zoomAt(event->position(), std::pow(perNotch, turned / notch));
    event->accept();
}

void MicroscopeView::keyPressEvent(QKeyEvent* event)
{
    const double step = event->modifiers() & Qt::ShiftModifier ? 10 : 1;
    const double up = microscope_.tracedLine().y == app::YAxis::Up ? step : -step;
    const auto by = [&](double x, double y) {
        moveEnd(*chosen_, nudged(frame_, endOf(microscope_.tracedLine().line, *chosen_), x, y));
        keepInSight();
    };
    if (event->key() == Qt::Key_Escape && drag_)
        return cancelDrag();
    if (!chosen_)
        return QWidget::keyPressEvent(event);
    switch (event->key()) {
    case Qt::Key_Left:
        return by(-step, 0);
    case Qt::Key_Right:
        return by(step, 0);
    case Qt::Key_Up:
        return by(0, up);
    case Qt::Key_Down:
        return by(0, -up);
    case Qt::Key_Escape:
        return choose({});
    default:
        QWidget::keyPressEvent(event);
    }
}

/// Tab goes from the view to End 1, then End 2, then to the next widget.
bool MicroscopeView::focusNextPrevChild(bool next)
{
    const std::optional<LineEnd> first = next ? LineEnd::One : LineEnd::Two;
    const std::optional<LineEnd> second = next ? LineEnd::Two : LineEnd::One;
    if (chosen_ == second)
        return QWidget::focusNextPrevChild(next);
    choose(chosen_ ? second : first);
    return true;
}

void MicroscopeView::leaveEvent(QEvent*)
{
    if (!drag_)
        hovered_.reset();
    update();
    emit pointerMoved({});
}

void MicroscopeView::focusInEvent(QFocusEvent* event)
{
    QWidget::focusInEvent(event);
    ring_ = event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason;
}

void MicroscopeView::focusOutEvent(QFocusEvent* event)
{
    QWidget::focusOutEvent(event);
    choose({});
}

void MicroscopeView::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange)
        fit();
    if (event->type() == QEvent::LocaleChange)
        describe(); // the numbers
}

/// The arrow keys step unless an end is selected, which they move.
bool MicroscopeView::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        const bool arrow = key >= Qt::Key_Left && key <= Qt::Key_Down;
        if ((chosen_ && (arrow || key == Qt::Key_Escape)) || (drag_ && key == Qt::Key_Escape)) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

} // namespace ui

#include "moc_microscope_view.cpp"
