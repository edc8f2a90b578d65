// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/frame_drag.h"

#include "app/drawing/frame_measures.h"
#include "app/drawing/transformation.h"
#include "ui/tools/shape_drawing.h"

namespace ui {

app::Point HeldHandle::place() const
{
    return app::outOfFrame(frame, app::placeOf(handle, frame.box));
}

app::Point HeldHandle::fixed(Qt::KeyboardModifiers modifiers) const
{
    const bool centre = anchorOf(modifiers) == app::Anchor::Centre;
    const app::Handle opposite = centre ? app::Handle{} : app::Handle{-handle.x, -handle.y};
    return app::outOfFrame(frame, app::placeOf(opposite, frame.box));
}

const app::GestureMeasure& HeldHandle::measure(Qt::KeyboardModifiers modifiers) const
{
    if (modifiers & Qt::ShiftModifier)
        return app::scalingMeasure(app::Along::Both);
    const app::Anchor anchor = anchorOf(modifiers);
    const bool corner = handle.x != 0 && handle.y != 0, upright = frame.angle == 0;
    if (corner)
        return upright ? app::widthAndHeight(app::Proportion::Free, anchor)
                       : app::rotatedWidthAndHeight(anchor);
    const int axis = handle.x != 0 ? 0 : 1;
    return upright ? app::sideLength(axis, anchor) : app::rotatedSideLength(axis, anchor);
}

app::GestureStart HeldHandle::start(Qt::KeyboardModifiers modifiers) const
{
    const app::Point from = fixed(modifiers);
    if (modifiers & Qt::ShiftModifier || frame.angle == 0)
        return {from, place()};
    const app::Point centre = app::centreOf(frame.box);
    return {from, from + app::outOfFrame(frame, centre + app::Point(1, 0)) - centre};
}

} // namespace ui
