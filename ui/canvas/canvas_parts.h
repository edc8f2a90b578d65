// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/backend.h"
#include "ui/canvas/pane_widget.h"
#include "ui/canvas/ruler.h"

namespace ui {

/// What a canvas is made of.
struct Canvas::Parts {
    Parts(app::Session& session, Backend wish, Canvas& canvas);

    PaneWidget& activeWidget() { return *widgets[place(panes.active()).value_or(0)]; }
    /// The widget that shows a pane; nothing where it has no room.
    std::optional<std::size_t> place(std::size_t pane) const;
    void repaint();

    Controller controller;
    Choice choice;
    RulerCorner corner;
    Ruler top, left;
    app::Panes panes;
    std::vector<std::size_t> shown;                   ///< the pane of each widget in sight
    std::vector<std::unique_ptr<PaneWidget>> widgets; ///< those of `shown`, and resting ones
    bool layingOut = false;
};

} // namespace ui
