// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/overlay_of.h"

#include "app/overlays/family.h"
#include "app/teaching/teaching.h"

#include <cmath>

namespace app {

namespace {

bool isFinite(const Point& p) { return std::isfinite(p.x) && std::isfinite(p.y); }

} // namespace

Overlay overlayOf(const OverlaySubject& subject)
{
    const clipping::Segment some{subject.window.min, subject.window.max};
    if (const QString why = refusalOf({.variant = subject.variant,
                                       .line = subject.line.value_or(some),
                                       .window = subject.window});
        !why.isEmpty())
        return {.caption = why};
    OverlayContext context{subject};
    if (context.pointer && !isFinite(*context.pointer))
        context.pointer.reset();
    if (context.line)
        context.trace = context.traceOf(*context.line);
    return teachingOf(*subject.variant.algorithm).overlay(context);
}

} // namespace app
