// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/tool.h"

namespace ui {

/// A drag of the clip window by a handle, its outline or its interior. Sets the session's preview
/// during the gesture and pushes one command at its end.
class WindowGesture {
public:
    void start(app::Handle handle, const Pointer& pointer, const clipping::Window& window);
    void startNew(const Pointer& pointer); ///< drags a new clip window from corner to corner
    void proceed(const Pointer& pointer, Workbench& bench);
    void finish(const Pointer& pointer, Workbench& bench);
    void cancel(Workbench& bench);

    bool going() const { return state_.has_value(); }
    /// Where the moved window snaps; null: it is not moved.
    const app::MovedSnap* snapped() const;

private:
    void follow(const Pointer& pointer, const Workbench& bench);
    app::MovedSnap moved(const Workbench& bench) const;
    bool moves() const { return state_ && state_->start && state_->handle == app::Handle{}; }
    /// Nothing until the pointer has moved far enough for a drag.
    std::optional<clipping::Window> window() const;
    app::Preview preview() const;

    struct State {
        app::Handle handle;
        Pointer from, to;
        std::optional<clipping::Window> start; ///< empty: a new window
        bool drags = false;
        app::MovedSnap moved{}; ///< if the whole window is moved
    };
    std::optional<State> state_;
};

/// The cursor over a handle.
Qt::CursorShape cursorOf(app::Handle handle);

} // namespace ui
