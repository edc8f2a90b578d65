// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/drawing/frame_measures.h"
#include "app/drawing/transformation.h"
#include "ui/tools/shape_drawing.h"
#include "ui/tools/window_gesture.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

// The numbers of a drag of a clip window.

namespace ui {

app::Point WindowGesture::handle() const
{
    return app::outOfFrame(state_->frame, app::placeOf(state_->handle, state_->frame.box));
}

app::Point WindowGesture::fixed() const
{
    const auto [x, y] = state_->handle;
    const bool centre = anchorOf(state_->to.modifiers) == app::Anchor::Centre;
    const app::Handle opposite = centre ? app::Handle{} : app::Handle{-x, -y};
    return app::outOfFrame(state_->frame, app::placeOf(opposite, state_->frame.box));
}

const app::GestureMeasure& WindowGesture::measure() const
{
    if (moves())
        return app::lengthAndAngle();
    if (rotates())
        return app::rotationMeasure(app::Along::Both);
    const auto [x, y] = state_->handle;
    if (state_->to.modifiers & Qt::ShiftModifier)
        return app::scalingMeasure(app::Along::Both);
    const app::Anchor anchor = anchorOf(state_->to.modifiers);
    const bool corner = x != 0 && y != 0, upright = state_->frame.angle == 0;
    if (corner)
        return upright ? app::widthAndHeight(app::Proportion::Free, anchor)
                       : app::rotatedWidthAndHeight(anchor);
    const int axis = x != 0 ? 0 : 1;
    return upright ? app::sideLength(axis, anchor) : app::rotatedSideLength(axis, anchor);
}

app::GestureStart WindowGesture::gaugeStart() const
{
    if (moves())
        return {state_->from.raw};
    const app::WindowFrame& frame = state_->frame;
    const app::Point centre = app::centreOf(frame.box);
    if (rotates())
        return {centre, state_->from.raw};
    const bool scales = state_->to.modifiers & Qt::ShiftModifier;
    if (scales || frame.angle == 0)
        return {fixed(), handle()};
    return {fixed(), fixed() + app::outOfFrame(frame, centre + app::Point(1, 0)) - centre};
}

app::Point WindowGesture::reached() const
{
    if (moves())
        return state_->from.raw + state_->moved.by;
    if (rotates())
        return app::rotation(-glm::degrees(angle()), gaugeStart().from)(state_->from.raw);
    const app::WindowFrame now = resized();
    const auto [x, y] = state_->handle;
    const app::Point at = app::outOfFrame(now, app::placeOf({x, y}, now.box));
    const app::Point opposite = app::outOfFrame(now, app::placeOf({-x, -y}, now.box));
    const app::Point& pointer = state_->to.raw; // beyond the other side, the frame is flipped
    return glm::distance(at, pointer) <= glm::distance(opposite, pointer) ? at : opposite;
}

std::optional<app::Gauge> WindowGesture::gauge(const Workbench& bench) const
{
    if (!state_ || !state_->drags)
        return std::nullopt;
    app::Gauge gauge = gaugeFrom({}, measure(), bench);
    gauge.start = gaugeStart();
    if (!moves() && !rotates())
        gauge.shift = handle() - state_->from.raw;
    if (!state_->to.held) { // where it is now: it may have snapped, or gone by a step
        const app::Point at = reached();
        gauge.aim = app::GestureEnd{at, gauge.measure->values(gauge.start, at)};
    }
    return gauge;
}

} // namespace ui
