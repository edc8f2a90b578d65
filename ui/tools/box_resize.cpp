// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/box_resize.h"

#include "app/commands/resize_objects.h"
#include "app/drawing/transformation.h"
#include "app/view/snapping/handle_snap.h"
#include "ui/look/text.h"
#include "ui/tools/shape_drawing.h"
#include "ui/tools/transform_gesture.h"

#include <glm/common.hpp>

namespace ui {
namespace {

/// A side would lose its whole extent, which no later step could give back.
bool collapses(const clipping::Window& from, const clipping::Window& to)
{
    for (int axis = 0; axis < 2; ++axis)
        if (from.min[axis] != from.max[axis] && to.min[axis] == to.max[axis])
            return true;
    return false;
}

} // namespace

void BoxResize::start(const HeldHandle& held, const Pointer& pressed, const Workbench& bench)
{
    last_.forget();
    now_ = State{
        held, pressed.raw, bench.session.selection(), {held.place(), {1, 1}}, pressed.modifiers};
}

void BoxResize::proceed(const Pointer& pointer, Workbench& bench)
{
    app::Point to = pointer.position;
    now_->snap.reset();
    if (!corrects())
        now_->modifiers = pointer.modifiers;
    if (!corrects() && !pointer.held) {
        now_->snap = snap(*now_, pointer.raw - now_->pressed, bench);
        to = now_->held.place() + now_->snap->by;
    }
    // Not the pointer's numbers: Shift or Alt may have changed what they measure.
    const app::GestureStart start = now_->held.start(now_->modifiers);
    now_->end = {to, now_->held.measure(now_->modifiers).values(start, to)};
}

// Boxes of other objects are upright, so a frame that is turned is not aligned with them.
app::MovedSnap BoxResize::snap(const State& state, const app::Point& by, const Workbench& bench)
{
    const app::Point at = state.held.place();
    const app::OwnPoints own{{at}, {at, at}};
    const bool upright = state.held.frame.angle == 0;
    const auto proportion =
        state.modifiers & Qt::ShiftModifier ? app::Proportion::Kept : app::Proportion::Free;
    const app::MovedSnap snap = bench.moved(own, by, state.modifiers, state.objects,
                                            upright ? app::SnapTo::All : placesOnly());
    if (!upright && proportion == app::Proportion::Free)
        return snap; // its side will pass through the place
    return app::heldByHandle({state.held.handle, at, state.held.fixed(state.modifiers), proportion},
                             by, snap);
}

bool BoxResize::finish(const Pointer& pointer, Workbench& bench)
{
    proceed(pointer, bench);
    accept(now_->end, bench);
    return true;
}

void BoxResize::accept(const app::GestureEnd& end, Workbench& bench)
{
    app::Session& session = bench.session;
    State state = *now_;
    state.end = end;
    const app::WindowFrame& from = state.held.frame;
    const app::WindowFrame to = target(state);
    if (session.selection() != state.objects)
        return cancel(bench); // a command has removed objects meanwhile
    if (collapses(from.box, to.box)) {
        emit session.refused(
            Text::tr("The selection would have no width or no height. Drag the handle elsewhere."));
        return cancel(bench);
    }
    now_.reset();
    last_.discard(); // if the step was open, it stays undone
    if (to == from)
        return last_.forget();
    pushKeepingInspected(session, new app::ResizeObjects(session.document, state.objects, from, to,
                                                         session.arrange.strokes));
    last_.remember(bench);
    done_ = std::move(state);
}

void BoxResize::cancel(Workbench& bench)
{
    now_.reset();
    last_.restore(bench);
}

void BoxResize::reopen(Workbench& bench)
{
    if (!last_.reopen(bench))
        return;
    bench.session.select(done_.objects);
    now_ = done_;
    now_->snap.reset();
}

app::WindowFrame BoxResize::target(const State& state)
{
    const app::WindowFrame& old = state.held.frame;
    if (state.modifiers & Qt::ShiftModifier) {
        const app::Point fixed = app::intoFrame(old, state.held.fixed(state.modifiers));
        const app::AffineMap map = app::scaling(app::Point(state.end.numbers[0]), fixed);
        const app::Point a = map(old.box.min), b = map(old.box.max);
        return app::resized(old, {glm::min(a, b), glm::max(a, b)});
    }
    return app::dragged(old, state.held.handle, state.held.place(), state.end.point,
                        app::Proportion::Free, anchorOf(state.modifiers));
}

std::optional<app::Gauge> BoxResize::gauge(const Workbench& bench) const
{
    if (!now_ && !canReopen(bench))
        return std::nullopt;
    const State& state = now_ ? *now_ : done_;
    app::Gauge gauge = gaugeFrom({}, state.held.measure(state.modifiers), bench);
    gauge.start = state.held.start(state.modifiers);
    gauge.shift = state.held.place() - state.pressed;
    if (!now_ || corrects())
        gauge.aim = done_.end;
    else if (state.snap)
        gauge.aim = state.end;
    return gauge;
}

void BoxResize::paint(QPainter& painter, const Workbench& bench) const
{
    if (now_)
        paintMapped(painter, bench, app::fitting(now_->held.frame, target()));
}

} // namespace ui
