// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/frame_handles.h"
#include "ui/tools/tool.h"

namespace ui {

/// A drag of a clip window by a handle, its outline or its interior. Sets the session's preview
/// during the gesture and pushes one command at its end.
class WindowGesture {
public:
    /// On the window that tools act on.
    void start(app::Handle handle, const Pointer& pointer, const Workbench& bench);
    /// Drags the window that tools act on anew, from corner to corner; without one, a first one.
    void startNew(const Pointer& pointer);
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
    std::optional<app::WindowShape> shape() const;
    app::WindowShape drawn() const;
    app::WindowShape dragged() const;
    app::Preview::Drag drag() const;
    double angle() const;

    struct State {
        app::Handle handle;
        Pointer from, to;
        std::optional<app::WindowShape> start{}; ///< empty: a new window
        app::WindowFrame frame{};                ///< of `start`
        bool drags = false;
        app::MovedSnap moved{}; ///< if the whole window is moved
    };
    std::optional<State> state_;
};

/// The cursor over a handle of a frame that is rotated by `angle` (radians).
Qt::CursorShape cursorOf(app::Handle handle, double angle = 0);

/// The handle of the window that tools act on; empty without a window.
std::optional<app::Handle> windowHandleAt(const app::Point& screen, const Workbench& bench);

} // namespace ui
