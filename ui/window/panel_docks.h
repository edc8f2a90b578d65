// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/docks/dock.h"

namespace ui {

/// The docks of a window by their part in its layout.
struct PanelDocks {
    Dock* start;     ///< in front until a drawing is opened or changed
    Dock* algorithm; ///< always at the top of the stack, with a place of its own
    Dock* window;
    Dock* selection;
    Dock* line; ///< small until a line is inspected
    Dock* layers;
    QList<Dock*> wide; ///< the comparison panels: above the others, in a wider column

    /// The working panels from top to bottom.
    QList<Dock*> stack() const { return {algorithm, window, selection, line, layers}; }
    QList<Dock*> narrow() const { return QList<Dock*>{start} + stack(); }
    QList<Dock*> all() const { return narrow() + wide; }
};

} // namespace ui
