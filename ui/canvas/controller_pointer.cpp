// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/area_at.h"
#include "ui/canvas/controller.h"
#include "ui/canvas/window_offer.h"
#include "ui/canvas/window_tags.h"
#include "ui/editing/keeping.h"
#include "ui/tools/group_choice.h"
#include "ui/tools/picking_marks.h"
#include "ui/tools/window_gesture.h"

#include <QGuiApplication>

#include <glm/geometric.hpp>

// The pointer over the canvas.

namespace ui {

// Ctrl suspends snapping.
std::optional<app::Snap> Controller::snapAt(const app::Point& raw,
                                            Qt::KeyboardModifiers modifiers) const
{
    app::SnapQuery query{raw, bench_.inDrawing(snapReach), snapNow_};
    tool_->as<Snaps>().limit(query);
    if (query.to == app::SnapTo::Nothing || modifiers & Qt::ControlModifier)
        return std::nullopt;
    const auto* measure = readout_ ? readout_->gauge().measure : nullptr;
    if (measure == &app::lengthAndAngle() || measure == &app::lengthAndAngle(app::Anchor::Centre))
        query.from = readout_->gauge().start.from;
    query.grid = bench_.grid();
    query.guides = bench_.guides();
    if (tool_->busy())
        query.seen = view().visible();
    return snapper_.at(query);
}

Pointer Controller::pointerAt(const QPointF& screen, Qt::MouseButtons buttons,
                              Qt::KeyboardModifiers modifiers)
{
    const app::Point at(screen.x(), screen.y()), raw = view().toDrawing(at);
    snap_ = snapAt(raw, modifiers);
    app::Point position = snap_ ? snap_->point : raw;
    if (readout_ && tool_->busy() && modifiers & Qt::ShiftModifier)
        position = readout_->toStep(position);
    if (snap_ && glm::distance(position, snap_->point) > bench_.inDrawing(0.1))
        snap_.reset(); // with Shift the line does not lead there
    Pointer pointer{position, raw, at, buttons, modifiers, position};
    steer(pointer);
    return pointer;
}

bool Controller::selectAt(const QPointF& screen)
{
    endGesture();
    const Pointer pointer = pointerAt(screen, Qt::NoButton, Qt::NoModifier);
    if (tool_->as<SelectsForMenu>().selectForMenu(pointer, bench_))
        return true;
    const auto [segment, object] = pickedAt(pointer.raw, bench_);
    if (!object)
        return false;
    if (!session_.selection().contains(*object) && choose(object, {}, session_))
        session_.inspect(segment);
    return true;
}

/// The clip window whose name is there.
std::optional<std::size_t> Controller::nameAt(const QPointF& screen) const
{
    if (tool_->busy() || !clipWindow())
        return std::nullopt;
    std::optional<std::size_t> uppermost;
    for (const WindowTag& tag : windowTags(*this, QGuiApplication::font()))
        if (tag.place.contains(screen))
            uppermost = tag.number;
    return uppermost;
}

std::optional<std::size_t> Controller::tagAt(const QPointF& screen) const
{
    const bool selects = toolInfo_->key == "select"; // others begin something there
    return selects && !windowHandleAt({screen.x(), screen.y()}, bench_) ? nameAt(screen)
                                                                        : std::nullopt;
}

bool Controller::chooseWindowAt(const QPointF& screen)
{
    constexpr double reach = 4; // pixels
    endGesture();
    const app::Point at{screen.x(), screen.y()}, there = view().toDrawing(at);
    const auto object = pickedAt(there, bench_).object;
    if (object && session_.selection().contains(*object))
        return false;
    if (toolInfo_->showsHandles() && windowHandleAt(at, bench_))
        return true; // of the one that tools act on
    auto number = nameAt(screen);
    if (!number && !object)
        number = app::windowBorderAt(session_.windows(), there, bench_.inDrawing(reach));
    if (number)
        session_.chooseWindow(*number);
    return number.has_value();
}

QRectF Controller::offeredHandle() const
{
    if (clipWindow() || !toolInfo_->showsHandles())
        return {};
    return offerPlace(session_.now().page().rectangle(), view());
}

void Controller::pointerEvent(QMouseEvent& event)
{
    if (event.type() == QEvent::MouseMove)
        move(event);
    else if (event.type() == QEvent::MouseButtonRelease)
        release(event);
    else if (event.type() == QEvent::MouseButtonDblClick && event.button() == Qt::MiddleButton)
        fitDrawing();
    else
        press(event);
    pointer_ = pointerAt(event.position(), event.buttons(), event.modifiers());
    if (event.type() == QEvent::MouseButtonRelease)
        snap_.reset(); // the snapped action is finished
    emit pointerMoved(pointer_->position);
    if (readout_)
        emit readoutChanged();
}

void Controller::press(QMouseEvent& event)
{
    if (event.button() == Qt::MiddleButton || (event.button() == Qt::LeftButton && space_)) {
        panningFrom_ = event.position();
        emit changed();
        return;
    }
    if (event.button() != Qt::LeftButton || pressOffer(event))
        return;
    const Pointer pointer = pointerAt(event.position(), event.buttons(), event.modifiers());
    if (!mayDraw()) {
        emit session_.refused(hint());
        return;
    }
    withTool([&] {
        event.type() == QEvent::MouseButtonDblClick ? tool_->doubleClick(pointer, bench_)
                                                    : tool_->press(pointer, bench_);
    });
}

// Whether the offered handle or the name of a window takes the click. At the second press of a
// double click it no longer exists.
bool Controller::pressOffer(const QMouseEvent& event)
{
    if (onOffer_ && event.type() == QEvent::MouseButtonDblClick)
        return true;
    const auto tag = tagAt(event.position());
    onOffer_ = tag || offeredHandle().contains(event.position());
    if (tag)
        session_.chooseWindow(*tag);
    else if (onOffer_)
        layWindowOnPage(session_);
    return onOffer_;
}

void Controller::move(QMouseEvent& event)
{
    if (panningFrom_) {
        navigation_.pan(event.position() - *panningFrom_);
        panningFrom_ = event.position();
        return;
    }
    const Pointer pointer = pointerAt(event.position(), event.buttons(), event.modifiers());
    withTool([&] {
        pointer_ = pointer; // the hint depends on it, too
        tool_->move(pointer, bench_);
    });
}

void Controller::release(QMouseEvent& event)
{
    if (panningFrom_ && (event.button() == Qt::MiddleButton || event.button() == Qt::LeftButton)) {
        panningFrom_.reset();
        emit changed();
        return;
    }
    if (event.button() != Qt::LeftButton || onOffer_)
        return;
    const Pointer pointer = pointerAt(event.position(), event.buttons(), event.modifiers());
    withTool([&] { tool_->release(pointer, bench_); });
}

} // namespace ui
