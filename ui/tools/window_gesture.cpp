// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/window_gesture.h"

#include "app/session/limited_steps.h"
#include "ui/tools/shape_drawing.h"

#include <cmath>

namespace ui {

void WindowGesture::start(app::Handle handle, const Pointer& pointer,
                          const clipping::Window& window)
{
    state_ = State{handle, pointer, pointer, window};
}

void WindowGesture::startNew(const Pointer& pointer)
{
    state_ = State{{1, 1}, pointer, pointer, std::nullopt};
}

void WindowGesture::follow(const Pointer& pointer, const Workbench& bench)
{
    if (!state_)
        return;
    state_->to = pointer;
    state_->drags |= dragged(state_->from.screen, pointer);
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
    app::MovedSnap moved = bench.moved(app::ownPointsOf(*state_->start), by, state_->to.modifiers,
                                       {}, app::SnapTo::All.without("window"));
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
    bench.session.setPreview(preview());
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
    const auto result = window();
    state_.reset();
    if (result && result != app::firstWindow(bench.session.now().windows()))
        app::placeClipWindow(bench.session, *result);
    bench.session.setPreview({});
}

std::optional<clipping::Window> WindowGesture::window() const
{
    if (!state_ || !state_->drags)
        return std::nullopt;
    const auto modifiers = state_->to.modifiers;
    if (!state_->start)
        return app::between(state_->from.position, state_->to.position, proportionOf(modifiers),
                            anchorOf(modifiers));
    // The pointer is rarely exactly on the handle, so the handle moves by as much as the pointer,
    // or to the snap point.
    app::Point by = moves() ? state_->moved.by : state_->to.raw - state_->from.raw;
    const bool snapped = state_->to.position != state_->to.raw;
    if (!moves() && snapped)
        for (int axis = 0; axis < 2; ++axis) {
            const int side = axis == 0 ? state_->handle.x : state_->handle.y;
            const auto& start = *state_->start;
            by[axis] = state_->to.position[axis] - (side < 0 ? start.min[axis] : start.max[axis]);
        }
    const auto proportion =
        modifiers & Qt::ShiftModifier ? app::Proportion::Kept : app::Proportion::Free;
    return app::dragged(*state_->start, state_->handle, by, proportion, anchorOf(modifiers));
}

app::Preview WindowGesture::preview() const
{
    const auto now = window();
    if (!now)
        return {};
    return {.window = now,
            .drag = moves() ? app::Preview::Drag::Moving : app::Preview::Drag::Sizing};
}

Qt::CursorShape cursorOf(app::Handle handle)
{
    if (handle.x == 0 && handle.y == 0)
        return Qt::SizeAllCursor;
    if (handle.x == 0)
        return Qt::SizeVerCursor;
    if (handle.y == 0)
        return Qt::SizeHorCursor;
    return handle.x == handle.y ? Qt::SizeFDiagCursor : Qt::SizeBDiagCursor;
}

} // namespace ui
