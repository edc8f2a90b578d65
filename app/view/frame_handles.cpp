// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/frame_handles.h"

#include "app/document/direction.h"

#include <glm/common.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>

namespace app {
namespace {

WindowFrame turned(const WindowFrame& start, const Point& from, const Point& to,
                   Proportion proportion)
{
    const Point centre = centreOf(start.box);
    constexpr double step = 15;
    double by = degreesOf(to - centre) - degreesOf(from - centre);
    if (proportion != Proportion::Free) {
        const double now = -glm::degrees(start.angle);
        by = std::round((now + by) / step) * step - now;
    }
    double angle = start.angle - glm::radians(by);
    angle = std::remainder(angle, 2 * glm::radians(180.0));
    return {start.box, std::abs(angle) < 1e-12 ? 0 : angle};
}

} // namespace

Point unrotated(const WindowFrame& frame, const View& view, const Point& screen)
{
    return frame.angle == 0 ? screen : view.toScreen(intoFrame(frame, view.toDrawing(screen)));
}

Point rotated(const WindowFrame& frame, const View& view, const Point& screen)
{
    return frame.angle == 0 ? screen : view.toScreen(outOfFrame(frame, view.toDrawing(screen)));
}

Point placeOfRotation(const WindowFrame& frame, const View& view)
{
    const Point above = view.toScreen(placeOf({0, -1}, frame.box)) - Point(0, rotationHandleAbove);
    return rotated(frame, view, above);
}

std::vector<PlacedHandle> placedHandles(const WindowFrame& frame, const View& view)
{
    std::vector<PlacedHandle> placed = placedHandles(frame.box, view);
    for (PlacedHandle& handle : placed)
        handle.screen = rotated(frame, view, handle.screen);
    placed.push_back({rotationHandle, placeOfRotation(frame, view)});
    return placed;
}

std::optional<Handle> handleAt(const Point& screen, const WindowFrame& frame, const View& view)
{
    const Point at = unrotated(frame, view, screen);
    const Point away = glm::abs(at - unrotated(frame, view, placeOfRotation(frame, view)));
    constexpr double reach = 12;
    if (away.x <= reach && away.y <= reach)
        return rotationHandle;
    return handleAt(at, frame.box, view);
}

WindowFrame dragged(const WindowFrame& start, Handle handle, const Point& from, const Point& to,
                    Proportion proportion, Anchor anchor)
{
    if (handle == rotationHandle)
        return turned(start, from, to, proportion);
    const Point by = intoFrame(start, to) - intoFrame(start, from);
    return resized(start, dragged(start.box, handle, by, proportion, anchor));
}

} // namespace app
