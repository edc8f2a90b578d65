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

void BoxResize::start(app::Handle handle, const clipping::Window& bounds, const Pointer& pressed,
                      const Workbench& bench)
{
    last_.forget();
    const app::Point at = app::placeOf(handle, bounds);
    now_ = State{handle,       bounds,           pressed.raw, bench.session.selection(),
                 {at, {1, 1}}, pressed.modifiers};
}

void BoxResize::proceed(const Pointer& pointer, Workbench& bench)
{
    app::Point to = pointer.position;
    now_->snap.reset();
    if (!corrects())
        now_->modifiers = pointer.modifiers;
    if (!corrects() && !pointer.held) {
        now_->snap = snap(*now_, pointer.raw - now_->pressed, bench);
        to = handleOf(*now_) + now_->snap->by;
    }
    // Not the pointer's numbers: Shift or Alt may have changed what they measure.
    const app::GestureStart start{fixed(*now_), handleOf(*now_)};
    now_->end = {to, measure(*now_).values(start, to)};
}

app::MovedSnap BoxResize::snap(const State& state, const app::Point& by, const Workbench& bench)
{
    const app::Point at = handleOf(state);
    const app::OwnPoints own{{at}, {at, at}};
    const auto proportion =
        state.modifiers & Qt::ShiftModifier ? app::Proportion::Kept : app::Proportion::Free;
    return app::heldByHandle({state.handle, at, fixed(state), proportion}, by,
                             bench.moved(own, by, state.modifiers, state.objects));
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
    const clipping::Window to = target(state);
    if (session.selection() != state.objects)
        return cancel(bench); // a command has removed objects meanwhile
    if (collapses(state.bounds, to)) {
        emit session.refused(
            Text::tr("The selection would have no width or no height. Drag the handle elsewhere."));
        return cancel(bench);
    }
    now_.reset();
    last_.discard(); // if the step was open, it stays undone
    if (to == state.bounds)
        return last_.forget();
    pushKeepingInspected(session,
                         new app::ResizeObjects(session.document, state.objects, state.bounds, to,
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

app::Point BoxResize::fixed(const State& state)
{
    const auto [x, y] = state.handle;
    const bool centre = anchorOf(state.modifiers) == app::Anchor::Centre;
    return app::placeOf(centre ? app::Handle{} : app::Handle{-x, -y}, state.bounds);
}

clipping::Window BoxResize::target(const State& state)
{
    const clipping::Window& old = state.bounds;
    if (state.modifiers & Qt::ShiftModifier) {
        const app::AffineMap map = app::scaling(app::Point(state.end.numbers[0]), fixed(state));
        const app::Point a = map(old.min), b = map(old.max);
        return {glm::min(a, b), glm::max(a, b)};
    }
    return app::dragged(old, state.handle, state.end.point - handleOf(state), app::Proportion::Free,
                        anchorOf(state.modifiers));
}

const app::GestureMeasure& BoxResize::measure(const State& state)
{
    const auto [x, y] = state.handle;
    if (state.modifiers & Qt::ShiftModifier)
        return app::scalingMeasure(app::Along::Both);
    const app::Anchor anchor = anchorOf(state.modifiers);
    return x != 0 && y != 0 ? app::widthAndHeight(app::Proportion::Free, anchor)
                            : app::sideLength(x != 0 ? 0 : 1, anchor);
}

std::optional<app::Gauge> BoxResize::gauge(const Workbench& bench) const
{
    if (!now_ && !canReopen(bench))
        return std::nullopt;
    const State& state = now_ ? *now_ : done_;
    app::Gauge gauge = gaugeFrom(fixed(state), measure(state), bench);
    gauge.start.pointer = handleOf(state);
    gauge.shift = gauge.start.pointer - state.pressed;
    if (!now_ || corrects())
        gauge.aim = done_.end;
    else if (state.snap)
        gauge.aim = state.end;
    return gauge;
}

void BoxResize::paint(QPainter& painter, const Workbench& bench) const
{
    if (!now_)
        return;
    const clipping::Window to = target();
    const app::Placement where = app::fitting(now_->bounds, to);
    paintMapped(painter, bench, {{where.scale.x, 0}, {0, where.scale.y}, now_->bounds.min, to.min});
}

} // namespace ui
