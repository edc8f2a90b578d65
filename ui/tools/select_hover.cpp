// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/select_hover.h"

#include "app/base/numbers.h"
#include "app/session/selection_frame.h"
#include "app/session/units.h"
#include "app/session/window_words.h"
#include "ui/look/text.h"
#include "ui/tools/guide_drag.h"
#include "ui/tools/selection_marks.h"
#include "ui/tools/window_gesture.h"

namespace ui {
namespace {

constexpr double boxReach = 8; // pixels
using Mark = PivotMarks::Mark;

/// %1 is the name of the clip window.
QString handleHint(app::Handle handle)
{
    if (handle == app::Handle{})
        return Text::tr("Drag: move the clip window %1. Right click: its menu.");
    if (handle == app::rotationHandle)
        return Text::tr("Drag: rotate the clip window %1. Right click: its menu.");
    return Text::tr("Drag: resize the clip window %1. Right click: its menu.");
}

QString segmentHint(std::size_t segment, const app::Session& session)
{
    const app::Containers& containers = session.now().containers();
    const std::size_t number = session.scene.lines().objectOf(segment);
    const auto layer = containers.layerOf(number);
    if (const app::ContainerId group = app::groupAt(session, number))
        return Text::tr("%1 of %2 objects in %3. Click: select, double click: enter, "
                        "Alt+click: one object.")
            .arg(app::groupName(containers[group]),
                 app::countText(containers.rangeOf(group).size()), containers[layer].name);
    return Text::tr("%1 in %2. Click: select, drag: move, double click: show its nodes.")
        .arg(app::objectText(session, number), containers[layer].name);
}

} // namespace

std::optional<app::WindowFrame> handledFrame(const app::Session& session)
{
    return lineWithHandles(session) ? std::nullopt : app::selectionFrame(session);
}

void SelectHover::look(const Pointer& pointer, const Workbench& bench)
{
    *this = {};
    lookNear(pointer, bench);
    window = windowHandleAt(pointer.screen, bench);
    if (window)
        return;
    end = EndDrag::endAt(pointer.screen, bench);
    if (!end)
        mark = PivotMarks::at(pointer.screen, bench);
    if (mark != Mark::None)
        return;
    if (const auto frame = handledFrame(bench.session))
        box = app::handleAt(app::unrotated(*frame, bench.view, pointer.screen),
                            SelectionMarks::around(*frame, bench).box, bench.view, boxReach);
    if (!box)
        segment = bench.picking.nearest(pointer.raw, bench.inDrawing(reach));
    if (!end && !box && !segment)
        guide = GuideDrag::guideAt(pointer.screen, bench);
}

void SelectHover::lookNear(const Pointer& pointer, const Workbench& bench)
{
    const auto frame = app::selectionFrame(bench.session);
    near = frame && SelectionMarks::isNear(pointer.screen, *frame, bench);
}

QCursor SelectHover::cursor(const app::Session& session) const
{
    if (window)
        return cursorOf(*window);
    if (mark != Mark::None)
        return Qt::PointingHandCursor;
    if (const auto frame = app::selectionFrame(session); box && frame) // it may have been removed
        return cursorOf(*box, frame->angle);
    return guide || end ? Qt::SizeAllCursor : Qt::ArrowCursor;
}

QString SelectHover::hint(const Workbench& bench) const
{
    const app::Session& session = bench.session;
    if (const auto number = session.windowNumber(); number && window)
        return handleHint(*window).arg(app::nameOf(session.windows().list[*number]));
    if (guide)
        return Text::tr("Drag the guide, or click it and press "
                        "Enter to type its position.");
    return segment && *segment < session.scene.lines().size() ? segmentHint(*segment, session)
                                                              : QString();
}

} // namespace ui
