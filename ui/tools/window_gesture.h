// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/tool.h"

namespace ui {

/// Dragging the clip window by a handle, its outline or its inside, for the tools that can: the
/// session's preview while the gesture goes on, and one command at its end.
class WindowGesture {
public:
    void start(app::Grip grip, const Pointer& pointer, const clipping::Window& window);
    void startNew(const Pointer& pointer); ///< another window, from corner to corner
    void proceed(const Pointer& pointer, Workbench& bench);
    void finish(const Pointer& pointer, Workbench& bench);
    void cancel(Workbench& bench);

    bool going() const { return state_.has_value(); }

private:
    void follow(const Pointer& pointer);
    std::optional<clipping::Window> window() const; ///< nothing before it is a drag
    app::Preview preview() const;

    struct State {
        app::Grip grip;
        Pointer from, to;
        std::optional<clipping::Window> start; ///< nothing: a new one
        bool drags = false;
    };
    std::optional<State> state_;
};

/// The cursor over a grip.
Qt::CursorShape cursorOf(app::Grip grip);

} // namespace ui
