// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/window_values.h"

#include "app/base/text.h"
#include "app/document/window_shape.h"
#include "app/session/window_steps.h"
#include "app/view/ruler.h"

#include <glm/trigonometric.hpp>

namespace app {
namespace {

bool isPlace(WindowValue which) { return which == WindowValue::X || which == WindowValue::Y; }

glm::length_t axisOf(WindowValue which)
{
    return which == WindowValue::X || which == WindowValue::Width ? 0 : 1;
}

WindowFrame frameInHand(const Session& session)
{
    return session.windowFrame().value_or(WindowFrame{session.window()});
}

Point originInHand(const Session& session)
{
    return originOf(session.now().page(), session.display().unit);
}

clipping::Window moved(clipping::Window box, glm::length_t axis, double to)
{
    const double size = box.max[axis] - box.min[axis];
    box.min[axis] = to;
    box.max[axis] = to + size;
    return box;
}

clipping::Window sized(clipping::Window box, glm::length_t axis, double length, bool keepsRatio)
{
    const Point size = box.max - box.min;
    const glm::length_t other = 1 - axis;
    box.max[axis] = box.min[axis] + length;
    if (keepsRatio && size[axis] > 0)
        box.max[other] = box.min[other] + size[other] * length / size[axis];
    return box;
}

} // namespace

double windowValue(const Session& session, WindowValue which)
{
    const WindowFrame frame = frameInHand(session);
    if (which == WindowValue::Angle)
        return 0 - glm::degrees(frame.angle);
    const glm::length_t axis = axisOf(which);
    return isPlace(which) ? frame.box.min[axis] - originInHand(session)[axis]
                          : frame.box.max[axis] - frame.box.min[axis];
}

void setWindowValue(Session& session, WindowValue which, double number, bool keepsRatio,
                    Merging merging)
{
    if (!session.windowFrame() || number == windowValue(session, which))
        return;
    const WindowShape& shape = session.windows().list[*session.windowNumber()].shape;
    if (which == WindowValue::Angle) {
        const double by = number - windowValue(session, WindowValue::Angle);
        return setWindowShape(session, rotated(shape, -glm::radians(by)),
                              Text::tr("Rotate clip window"), merging);
    }
    const WindowFrame frame = *session.windowFrame();
    const glm::length_t axis = axisOf(which);
    if (isPlace(which)) {
        const clipping::Window to = moved(frame.box, axis, originInHand(session)[axis] + number);
        return setWindowShape(session, fitted(shape, WindowFrame{to, frame.angle}),
                              Text::tr("Move clip window"), merging);
    }
    const clipping::Window to = sized(frame.box, axis, number, keepsRatio);
    setWindowShape(session, fitted(shape, resized(frame, to)), Text::tr("Resize clip window"),
                   merging);
}

} // namespace app
