// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/overlays/parts.h"

#include <QCoreApplication>

namespace app {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("Overlay", text); }

} // namespace

/// The lines of the bottom and the top edge, and the ends of the line.
Overlay bandOverlay(const Seeing& seeing)
{
    Overlay overlay;
    for (const clipping::Edge edge : {clipping::Edge::Bottom, clipping::Edge::Top})
        if (const auto line = border(edge, seeing))
            overlay.lines.push_back(*line);
    overlay.caption = tr("The band between the bottom and the top edge.");
    if (seeing.line) {
        overlay.marks = endMarks(*seeing.line, {}, {});
        overlay.caption += tr(" The line is cut there first.");
    }
    return overlay;
}

} // namespace app
