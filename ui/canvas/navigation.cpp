// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/navigation.h"

#include <QGuiApplication>

#include <utility>

namespace ui {

constexpr double notch = 120;              // QWheelEvent::angleDelta of one notch
constexpr double pixelsPerNotch = 48;      // panning with the wheel
constexpr double pinchPerPixel = 1 / 60.0; // notches per pixel of Ctrl and touchpad scrolling

static app::Point point(const QPointF& p) { return {p.x(), p.y()}; }

Navigation::Navigation(QObject* parent) : QObject(parent) { clock_.start(); }

void Navigation::go(const app::View& view)
{
    if (view == view_)
        return;
    history_.leave(view_, clock_.elapsed());
    forget();
    replace(view);
}

void Navigation::forget()
{
    fitted_.reset();
    held_.reset();
}

void Navigation::replace(const app::View& view)
{
    view_ = view;
    emit moved();
}

void Navigation::resize(const glm::dvec2& size, Keep keep)
{
    if (size == view_.size)
        return;
    app::View view = view_;
    view.size = size;
    if (keep == Keep::Corner && !held_)
        view.centre = view_.toDrawing({0, 0}) + size * 0.5 / view.zoom;
    else if (fitted_)
        fit(view, *fitted_);
    replace(view);
}

void Navigation::show(const clipping::Window& rectangle)
{
    app::View view = view_;
    const Fitted fitted{rectangle, Margin::Usual};
    fit(view, fitted);
    go(view);
    forget(); // also if nothing has moved
    fitted_ = fitted;
}

// The margin is smaller in small panes.
void Navigation::fit(app::View& view, const Fitted& fitted)
{
    constexpr double share = 0.06;
    const double least = share * std::min(view.size.x, view.size.y);
    view.fit(fitted.rectangle,
             fitted.margin == Margin::Usual ? std::min(app::View::usualMargin, least) : 0);
}

void Navigation::hold()
{
    if (!fitted_)
        fitted_ = {view_.visible(), Margin::None};
}

void Navigation::remember() { held_ = {view_, fitted_}; }

bool Navigation::release()
{
    const auto held = std::exchange(held_, std::nullopt);
    if (!held)
        return false;
    fitted_ = held->fitted;
    app::View view = held->view;
    view.size = view_.size;
    view.centre = held->view.toDrawing({0, 0}) + view.size * 0.5 / view.zoom;
    replace(view);
    return true;
}

void Navigation::pan(const QPointF& pixels)
{
    app::View view = view_;
    view.pan(point(pixels));
    go(view);
}

void Navigation::zoomAt(const QPointF& screen, double factor)
{
    app::View view = view_;
    view.zoomAt(point(screen), factor);
    go(view);
}

void Navigation::back()
{
    if (const auto view = history_.back(view_)) {
        forget();
        replace(*view);
    }
}

void Navigation::forth()
{
    if (const auto view = history_.forth(view_)) {
        forget();
        replace(*view);
    }
}

// A mouse wheel turns by whole notches and has no phases; but X11 reports pixel deltas for it too.
bool Navigation::isTouchpad(const QWheelEvent& event)
{
    if (event.phase() != Qt::NoScrollPhase)
        return true;
    const QPoint angle = event.angleDelta();
    return !event.pixelDelta().isNull()
           && (angle.x() % int(notch) != 0 || angle.y() % int(notch) != 0);
}

void Navigation::wheel(const QWheelEvent& event)
{
    const bool touchpad = isTouchpad(event);
    const QPointF angle = event.angleDelta();
    const QPointF pixels = touchpad && !event.pixelDelta().isNull()
                               ? QPointF(event.pixelDelta())
                               : angle * pixelsPerNotch / notch;
    if (event.modifiers() & Qt::ShiftModifier) {
        pan({pixels.x() != 0 ? pixels.x() : pixels.y(), 0});
        return;
    }
    if (touchpad && !(event.modifiers() & Qt::ControlModifier)) {
        pan(pixels);
        return;
    }
    app::View view = view_;
    wheel_.turn(view, point(event.position()),
                touchpad ? pixels.y() * pinchPerPixel : angle.y() / notch);
    go(view);
}

bool Navigation::gesture(const QNativeGestureEvent& event)
{
    if (event.gestureType() == Qt::ZoomNativeGesture)
        zoomAt(event.position(), 1 + event.value());
    else if (event.gestureType() == Qt::PanNativeGesture)
        pan(event.delta());
    else
        return false;
    return true;
}

} // namespace ui

#include "moc_navigation.cpp"
