// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/overlay_of.h"

#include "app/base/finite.h"
#include "app/document/window_frame.h"
#include "app/overlays/parts.h"
#include "app/teaching/teaching.h"

#include <glm/common.hpp>

#include <cmath>

namespace app {

namespace {

/// The rectangle around what is seen, in a frame's own directions.
clipping::Window seenIn(const WindowFrame& frame, const clipping::Window& seen)
{
    const auto corners = cornersOf({seen, 0});
    clipping::Window box{intoFrame(frame, corners[0]), intoFrame(frame, corners[0])};
    for (const Point& corner : corners) {
        const Point p = intoFrame(frame, corner);
        box = {glm::min(box.min, p), glm::max(box.max, p)};
    }
    return box;
}

OverlaySubject intoFrame(const WindowFrame& frame, OverlaySubject subject)
{
    if (subject.line)
        subject.line = {intoFrame(frame, subject.line->a), intoFrame(frame, subject.line->b)};
    if (subject.pointer)
        subject.pointer = intoFrame(frame, *subject.pointer);
    subject.seen = seenIn(frame, subject.seen);
    subject.angle = 0;
    return subject;
}

Overlay outOfFrame(const WindowFrame& frame, Overlay overlay)
{
    const Point origin = outOfFrame(frame, Point{});
    for (OverlayArea& area : overlay.areas)
        for (Point& corner : area.corners)
            corner = outOfFrame(frame, corner);
    for (OverlayLine& line : overlay.lines) {
        line.segment = {outOfFrame(frame, line.segment.a), outOfFrame(frame, line.segment.b)};
        line.outwards = outOfFrame(frame, line.outwards) - origin;
    }
    for (OverlayMark& mark : overlay.marks)
        mark.at = outOfFrame(frame, mark.at);
    return overlay;
}

} // namespace

Overlay overlayOf(const OverlaySubject& subject)
{
    if (subject.angle != 0 && std::isfinite(subject.angle)) {
        const WindowFrame frame{subject.window, subject.angle};
        return outOfFrame(frame, overlayOf(intoFrame(frame, subject)));
    }
    const clipping::Segment some{subject.window.min, subject.window.max};
    if (const QString why = refusalOf({.variant = subject.variant,
                                       .line = subject.line.value_or(some),
                                       .window = subject.window,
                                       .corners = subject.corners});
        !why.isEmpty())
        return {.caption = why};
    OverlayContext context{subject};
    if (context.pointer && !isFinite(*context.pointer))
        context.pointer.reset();
    if (context.line)
        context.trace = context.traceOf(*context.line);
    return subject.corners.empty() ? teachingOf(*subject.variant.algorithm).overlay(context)
                                   : polygonOverlay(context);
}

} // namespace app
