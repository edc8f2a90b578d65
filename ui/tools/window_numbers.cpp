// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/drawing/transformation.h"
#include "ui/tools/shape_drawing.h"
#include "ui/tools/window_gesture.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

// The numbers of a drag of a clip window.

namespace ui {

const app::GestureMeasure& WindowGesture::measure() const
{
    if (moves())
        return app::lengthAndAngle();
    if (rotates())
        return app::rotationMeasure(app::Along::Both);
    return held().measure(state_->to.modifiers);
}

app::GestureStart WindowGesture::gaugeStart() const
{
    if (moves())
        return {state_->from.raw};
    if (rotates())
        return {app::centreOf(state_->frame.box), state_->from.raw};
    return held().start(state_->to.modifiers);
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
        gauge.shift = held().place() - state_->from.raw;
    if (!state_->to.held) { // where it is now: it may have snapped, or gone by a step
        const app::Point at = reached();
        gauge.aim = app::GestureEnd{at, gauge.measure->values(gauge.start, at)};
    }
    return gauge;
}

} // namespace ui
