// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/drag.h"
#include "ui/tools/frame_drag.h"

namespace ui {

/// A drag of a clip window by a handle, its outline or its interior. Sets the session's preview
/// during the gesture and pushes one command at its end; typed numbers hold.
class WindowGesture final : public Drag {
public:
    /// On the window that tools act on.
    void start(app::Handle handle, const Pointer& pointer, const Workbench& bench);
    bool going() const override { return state_.has_value(); }
    void proceed(const Pointer& pointer, Workbench& bench) override;
    bool finish(const Pointer& pointer, Workbench& bench) override;
    void cancel(Workbench& bench) override;
    /// Width and height while a handle is dragged, an angle for the one that rotates, length and
    /// angle of a move.
    std::optional<app::Gauge> gauge(const Workbench& bench) const override;
    void accept(const app::GestureEnd& end, Workbench& bench) override;
    void limit(app::SnapQuery& query) const override { query.withoutWindow = state_->number; }
    const app::MovedSnap* snapped() const override; ///< the whole window, if it is moved

private:
    void follow(const Pointer& pointer, const Workbench& bench);
    app::MovedSnap moved(const Workbench& bench) const;
    bool moves() const { return state_ && state_->handle == app::Handle{}; }
    bool rotates() const { return state_ && state_->handle == app::rotationHandle; }
    /// Nothing until the pointer has moved far enough for a drag.
    std::optional<app::WindowShape> shape() const;
    app::WindowShape dragged() const;
    app::WindowFrame resized() const;
    app::Preview::Drag drag() const;
    double angle() const;
    void push(Workbench& bench);
    HeldHandle held() const { return {state_->handle, state_->frame}; }
    const app::GestureMeasure& measure() const;
    app::GestureStart gaugeStart() const;
    app::Point reached() const; ///< where what is dragged is now

    struct State {
        app::Handle handle;
        Pointer from, to;
        std::size_t number;     ///< of the window
        app::WindowShape start; ///< its shape
        app::WindowFrame frame; ///< of the shape
        app::OwnPoints own;     ///< by which it snaps
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
