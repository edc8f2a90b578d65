// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/seen_overlay.h"

#include "app/session/traced_window.h"
#include "app/teaching/overlay_of.h"
#include "ui/canvas/algorithm_overlay.h"
#include "ui/canvas/difference_overlay.h"
#include "ui/canvas/window_overlay.h"

namespace ui {
namespace {

std::optional<clipping::Segment> lineLookedAt(const Controller& controller)
{
    if (const auto& drawn = controller.session().preview().line)
        return drawn;
    const app::SceneLines& lines = controller.session().scene.lines();
    for (const auto& index : {controller.session().inspected(), controller.tool().hoveredSegment()})
        if (index && *index < lines.size())
            return lines[*index];
    return std::nullopt;
}

app::OverlaySubject subjectOf(const Controller& controller, const Pane& pane)
{
    const app::TracedWindow window = app::tracedWindow(controller.session());
    app::OverlaySubject subject{.variant = pane.choice,
                                .window = window.frame.box,
                                .line = lineLookedAt(controller),
                                .seen = controller.view().visible(),
                                .y = app::YAxis::Down,
                                .angle = window.frame.angle,
                                .corners = window.corners};
    if (controller.pointer())
        subject.pointer = controller.pointer()->position;
    return subject;
}

} // namespace

void paintWhatIsSeen(QPainter& painter, const Controller& controller, const Pane& pane)
{
    const app::Point size = controller.view().size;
    const QRectF room(0, 0, size.x, size.y - differenceLabelHeight(controller, pane));
    paintAlgorithmOverlay(
        painter, app::overlayOf(subjectOf(controller, pane)),
        {.room = room,
         .onScreen = [&](const app::Point& p) { return controller.bench().onScreen(p); },
         .look = controller.paperLook(),
         .page = controller.pageColour(),
         .taken = windowFurniture(controller, pane, painter.font()),
         .avoided = controller.textBoxes()});
}

} // namespace ui
