// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/backend.h"
#include "ui/canvas/canvas.h"
#include "ui/canvas/controller.h"
#include "ui/canvas/object_capsule.h"
#include "ui/canvas/pane_widget.h"
#include "ui/canvas/readout_box.h"
#include "ui/canvas/ruler.h"
#include "ui/canvas/text_box.h"
#include "ui/canvas/window_capsule.h"

namespace ui {

/// The parts of a canvas.
struct Canvas::Parts {
    Parts(app::Session& session, Backend wish, Canvas& canvas);

    PaneWidget& activeWidget() { return *widgets[place(panes.active()).value_or(0)]; }
    /// The index of the widget that shows a pane; nothing if there is no room for the pane.
    std::optional<std::size_t> place(std::size_t pane) const;
    void repaint();

    Controller controller;
    Choice choice;
    RulerCorner corner;
    Ruler top, left;
    app::Panes panes;
    std::vector<std::size_t> shown; ///< the pane of each visible widget
    /// The widgets of `shown`, then hidden widgets for reuse.
    std::vector<std::unique_ptr<PaneWidget>> widgets;
    ReadoutBox readout;
    TextBox text;
    WindowCapsule ofWindow;
    ObjectCapsule ofObjects;
    const std::array<Capsule*, 2> capsules{&ofWindow, &ofObjects};
    Capsule::Form capsuleForm = Capsule::Form::Whole;
    app::CapsuleHome capsuleHome = app::CapsuleHome::AtObject;
    QWidget* capsuleBar = nullptr; ///< of the options bar; null: there is none
    std::function<bool(const Carried&)> carrier;
    bool layingOut = false;
    QString hintOfFrame; ///< setHint()
    QSize cornerKeptIn;  ///< the window's size while keepCorner() holds; empty: it does not
};

} // namespace ui
