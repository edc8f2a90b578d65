// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/window_gesture.h"

#include "app/session/window_steps.h"
#include "ui/tools/shape_drawing.h"

#include <QCoreApplication>

#include <array>
#include <cmath>
#include <numbers>

namespace ui {

static QString nameOf(app::Preview::Drag drag)
{
    using Drag = app::Preview::Drag;
    const char* const move = QT_TRANSLATE_NOOP("Commands", "Move clip window");
    const char* const resize = QT_TRANSLATE_NOOP("Commands", "Resize clip window");
    const char* const rotate = QT_TRANSLATE_NOOP("Commands", "Rotate clip window");
    return QCoreApplication::translate("Commands", drag == Drag::Moving     ? move
                                                   : drag == Drag::Rotating ? rotate
                                                                            : resize);
}

void WindowGesture::start(app::Handle handle, const Pointer& pointer, const Workbench& bench)
{
    const app::Session& session = bench.session;
    if (const auto& frame = session.windowFrame())
        state_ = State{handle, pointer, pointer,
                       session.windows().list[*session.windowNumber()].shape, *frame};
}

void WindowGesture::startNew(const Pointer& pointer) { state_ = State{{1, 1}, pointer, pointer}; }

void WindowGesture::follow(const Pointer& pointer, const Workbench& bench)
{
    if (!state_)
        return;
    state_->to = pointer;
    state_->drags |= ui::dragged(state_->from.screen, pointer);
    if (moves())
        state_->moved = moved(bench);
}

// With Shift the window keeps to one axis, also where it would snap beside it.
app::MovedSnap WindowGesture::moved(const Workbench& bench) const
{
    app::Point by = state_->to.raw - state_->from.raw;
    const bool straight = state_->to.modifiers & Qt::ShiftModifier;
    const int fixed = std::abs(by.x) >= std::abs(by.y) ? 1 : 0;
    if (straight)
        by[fixed] = 0;
    app::MovedSnap moved =
        bench.moved(app::ownPointsOf(app::boxOf(state_->frame)), by, state_->to.modifiers, {},
                    app::SnapTo::All.without("window"));
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
    state_.reset();
    bench.session.setPreview({});
}

// The preview ends after the command, so that the window does not jump back in between.
void WindowGesture::finish(const Pointer& pointer, Workbench& bench)
{
    follow(pointer, bench);
    const auto result = shape();
    const app::Preview::Drag what = drag();
    const bool isNew = state_ && !state_->start;
    state_.reset();
    if (result)
        app::setWindowShape(bench.session, *result,
                            isNew ? QCoreApplication::translate("Commands", "Draw clip window")
                                  : nameOf(what));
    bench.session.setPreview({});
}

std::optional<app::WindowShape> WindowGesture::shape() const
{
    if (!state_ || !state_->drags)
        return std::nullopt;
    return state_->start ? dragged() : drawn();
}

app::WindowShape WindowGesture::drawn() const
{
    const auto modifiers = state_->to.modifiers;
    return app::RectangleShape{app::between(state_->from.position, state_->to.position,
                                            proportionOf(modifiers), anchorOf(modifiers))};
}

// The pointer is rarely exactly on the handle, so the handle moves by as much as the pointer, or to
// the snap point.
app::WindowShape WindowGesture::dragged() const
{
    if (moves())
        return app::mapped(*state_->start, app::translation(state_->moved.by));
    if (state_->handle == app::rotationHandle)
        return app::rotated(*state_->start, angle());
    const auto modifiers = state_->to.modifiers;
    const app::WindowFrame& start = state_->frame;
    const app::Handle handle = state_->handle;
    app::Point from = state_->from.raw, to = state_->to.raw;
    if (state_->to.position != state_->to.raw) {
        from = app::outOfFrame(start, app::placeOf(handle, start.box));
        to = state_->to.position;
    }
    const auto proportion =
        modifiers & Qt::ShiftModifier ? app::Proportion::Kept : app::Proportion::Free;
    const auto frame = app::dragged(start, handle, from, to, proportion, anchorOf(modifiers));
    return app::fitted(*state_->start, frame);
}

// By which the rotation handle was turned so far.
double WindowGesture::angle() const
{
    if (!state_ || !state_->start || state_->handle != app::rotationHandle)
        return 0;
    const app::WindowFrame& start = state_->frame;
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
    return moves()                                           ? Drag::Moving
           : state_ && state_->handle == app::rotationHandle ? Drag::Rotating
                                                             : Drag::Sizing;
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
