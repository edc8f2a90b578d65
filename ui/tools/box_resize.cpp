// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/box_resize.h"

#include "app/commands/resize_objects.h"
#include "app/drawing/transformation_measures.h"
#include "ui/tools/shape_drawing.h"
#include "ui/tools/transform_gesture.h"

#include <glm/common.hpp>

namespace ui {

void BoxResize::start(app::Handle handle, const clipping::Window& bounds, const Pointer& pressed)
{
    const app::Point at = app::placeOf(handle, bounds);
    now_ = State{handle, bounds, at - pressed.raw, {at, {1, 1}}, pressed.modifiers};
}

void BoxResize::proceed(const Pointer& pointer)
{
    now_->modifiers = pointer.modifiers;
    // Not the pointer's numbers: Shift or Alt may have changed what they measure.
    const app::GestureStart start{fixed(), app::placeOf(now_->handle, now_->bounds)};
    now_->end = {pointer.position, measure().values(start, pointer.position)};
}

void BoxResize::finish(Workbench& bench)
{
    if (now_)
        accept(now_->end, bench);
}

void BoxResize::accept(const app::GestureEnd& end, Workbench& bench)
{
    app::Session& session = bench.session;
    now_->end = end;
    const clipping::Window from = now_->bounds, to = target();
    now_.reset();
    if (session.selection().empty())
        return; // removed meanwhile
    pushKeepingInspected(session, new app::ResizeObjects(session.document, session.selection(),
                                                         from, to, session.arrange.strokes));
}

app::Point BoxResize::fixed() const
{
    const auto [x, y] = now_->handle;
    const bool centre = anchorOf(now_->modifiers) == app::Anchor::Centre;
    return app::placeOf(centre ? app::Handle{} : app::Handle{-x, -y}, now_->bounds);
}

clipping::Window BoxResize::target() const
{
    const clipping::Window& old = now_->bounds;
    if (now_->modifiers & Qt::ShiftModifier) {
        const app::AffineMap map = app::scaling(app::Point(now_->end.numbers[0]), fixed());
        const app::Point a = map(old.min), b = map(old.max);
        return {glm::min(a, b), glm::max(a, b)};
    }
    const app::Point by = now_->end.point - app::placeOf(now_->handle, old);
    return app::dragged(old, now_->handle, by, app::Proportion::Free, anchorOf(now_->modifiers));
}

const app::GestureMeasure& BoxResize::measure() const
{
    const auto [x, y] = now_->handle;
    if (now_->modifiers & Qt::ShiftModifier)
        return app::scalingMeasure(app::Along::Both);
    const app::Anchor anchor = anchorOf(now_->modifiers);
    return x != 0 && y != 0 ? app::widthAndHeight(app::Proportion::Free, anchor)
                            : app::sideLength(x != 0 ? 0 : 1, anchor);
}

app::Gauge BoxResize::gauge(const Workbench& bench) const
{
    app::Gauge gauge = gaugeFrom(fixed(), measure(), bench);
    gauge.start.pointer = app::placeOf(now_->handle, now_->bounds);
    gauge.shift = now_->shift;
    return gauge;
}

void BoxResize::paint(QPainter& painter, const Workbench& bench) const
{
    const clipping::Window to = target();
    const app::Placement where = app::fitting(now_->bounds, to);
    paintMapped(painter, bench, {{where.scale.x, 0}, {0, where.scale.y}, now_->bounds.min, to.min});
}

} // namespace ui
