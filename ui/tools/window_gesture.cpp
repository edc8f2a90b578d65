// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/window_gesture.h"

#include "app/session/window_steps.h"
#include "app/view/snapping/window_points.h"
#include "ui/look/text.h"
#include "ui/tools/shape_drawing.h"

#include <QCoreApplication>

#include <glm/trigonometric.hpp>

#include <array>
#include <cmath>
#include <numbers>

namespace ui {

static QString nameOf(app::Preview::Drag drag)
{
    using Drag = app::Preview::Drag;
    const char* const move = QT_TRANSLATE_NOOP("Text", "Move clip window");
    const char* const resize = QT_TRANSLATE_NOOP("Text", "Resize clip window");
    const char* const rotate = QT_TRANSLATE_NOOP("Text", "Rotate clip window");
    return Text::tr(drag == Drag::Moving ? move : drag == Drag::Rotating ? rotate : resize);
}

void WindowGesture::start(app::Handle handle, const Pointer& pointer, const Workbench& bench)
{
    app::Session& session = bench.session;
    const auto& frame = session.windowFrame();
    if (!frame)
        return;
    const std::size_t number = *session.windowNumber();
    session.chooseWindow(number);
    const app::WindowShape& shape = session.windows().list[number].shape;
    state_ = State{handle, pointer, pointer, number, shape, *frame, app::ownPointsOf(shape)};
}

void WindowGesture::follow(const Pointer& pointer, const Workbench& bench)
{
    if (!state_)
        return;
    state_->to = pointer;
    state_->drags |= pointer.held || ui::dragged(state_->from.screen, pointer);
    if (moves())
        state_->moved = moved(bench);
}

// With Shift the window keeps to one axis, also where it would snap beside it.
app::MovedSnap WindowGesture::moved(const Workbench& bench) const
{
    if (state_->to.held)
        return {state_->to.position - state_->from.raw};
    app::Point by = state_->to.raw - state_->from.raw;
    const bool straight = state_->to.modifiers & Qt::ShiftModifier;
    const int fixed = std::abs(by.x) >= std::abs(by.y) ? 1 : 0;
    if (straight)
        by[fixed] = 0;
    app::MovedSnap moved =
        bench.moved(state_->own, by, state_->to.modifiers, {}, app::SnapTo::All, state_->number);
    if (straight && moved.by[fixed] != 0) {
        moved = {moved.by};
        moved.by[fixed] = 0;
    }
    return moved;
}

const app::MovedSnap* WindowGesture::snapped() const
{
    return moves() && state_->drags ? &state_->moved : nullptr;
}

void WindowGesture::proceed(const Pointer& pointer, Workbench& bench)
{
    follow(pointer, bench);
    const auto now = shape();
    app::Preview preview;
    if (now)
        preview = {
            .windows = app::withShape(bench.session, *now), .drag = drag(), .angle = angle()};
    bench.session.setPreview(preview);
}

void WindowGesture::cancel(Workbench& bench)
{
    if (std::exchange(state_, std::nullopt))
        bench.session.setPreview({});
}

bool WindowGesture::finish(const Pointer& pointer, Workbench& bench)
{
    follow(pointer, bench);
    push(bench);
    return true;
}

void WindowGesture::accept(const app::GestureEnd& end, Workbench& bench)
{
    if (!state_)
        return;
    Pointer there = state_->to;
    there.position = end.point;
    there.numbers = end.numbers;
    there.held = true;
    finish(there, bench);
}

// The preview ends after the command, so that the window does not jump back in between.
void WindowGesture::push(Workbench& bench)
{
    const auto result = shape();
    const QString text = nameOf(drag());
    state_.reset();
    if (result)
        app::setWindowShape(bench.session, *result, text);
    bench.session.setPreview({});
}

std::optional<app::WindowShape> WindowGesture::shape() const
{
    return state_ && state_->drags ? std::optional(dragged()) : std::nullopt;
}

app::WindowShape WindowGesture::dragged() const
{
    if (moves())
        return app::mapped(state_->start, app::translation(state_->moved.by));
    if (rotates())
        return app::rotated(state_->start, angle());
    return app::fitted(state_->start, resized());
}

// The pointer is rarely exactly on the handle, so the handle moves by as much as the pointer, or to
// the snap point, or to what is typed.
app::WindowFrame WindowGesture::resized() const
{
    const Pointer& now = state_->to;
    app::Point from = state_->from.raw, to = now.raw;
    if (now.held || now.steered != now.raw) {
        from = held().place();
        to = now.held ? now.position : now.steered;
    }
    const auto proportion =
        now.modifiers & Qt::ShiftModifier ? app::Proportion::Kept : app::Proportion::Free;
    return app::dragged(state_->frame, state_->handle, from, to, proportion,
                        anchorOf(now.modifiers));
}

// By which the rotation handle was turned so far.
double WindowGesture::angle() const
{
    if (!rotates())
        return 0;
    const app::WindowFrame& start = state_->frame;
    if (state_->to.held)
        return -glm::radians(state_->to.numbers[0]);
    const auto proportion =
        state_->to.modifiers & Qt::ShiftModifier ? app::Proportion::Kept : app::Proportion::Free;
    return app::dragged(start, state_->handle, state_->from.raw, state_->to.raw, proportion,
                        app::Anchor::Opposite)
               .angle
           - start.angle;
}

app::Preview::Drag WindowGesture::drag() const
{
    using Drag = app::Preview::Drag;
    return moves() ? Drag::Moving : rotates() ? Drag::Rotating : Drag::Sizing;
}

Qt::CursorShape cursorOf(app::Handle handle, double angle)
{
    if (handle == app::Handle{})
        return Qt::SizeAllCursor;
    if (handle == app::rotationHandle)
        return Qt::PointingHandCursor;
    constexpr std::array cursors{Qt::SizeHorCursor, Qt::SizeFDiagCursor, Qt::SizeVerCursor,
                                 Qt::SizeBDiagCursor};
    const double eighths = std::atan2(handle.y, handle.x) + angle;
    const int step = int(std::lround(eighths / (std::numbers::pi / 4)));
    return cursors[std::size_t(((step % 4) + 4) % 4)];
}

std::optional<app::Handle> windowHandleAt(const app::Point& screen, const Workbench& bench)
{
    const app::Session& session = bench.session;
    const auto& frame = session.windowFrame();
    if (!frame)
        return std::nullopt;
    const app::WindowShape& shape = session.windows().list[*session.windowNumber()].shape;
    const auto handle = app::handleAt(screen, *frame, bench.view);
    // The frame of a path is not its outline.
    if (handle == app::Handle{} && std::holds_alternative<app::PathShape>(shape))
        return std::nullopt;
    return handle;
}

} // namespace ui
