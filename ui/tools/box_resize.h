// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object_ranges.h"
#include "ui/tools/last_step.h"

namespace ui {

/// Resizes the selection by a handle of its bounding box, which snaps. Shift keeps the proportions,
/// Alt the centre; typed numbers hold, and change what was just done.
class BoxResize {
public:
    void start(app::Handle handle, const clipping::Window& bounds, const Pointer& pressed,
               const Workbench& bench);
    bool going() const { return now_.has_value(); }
    bool corrects() const { return last_.isOpen(); } ///< the last step is open again
    bool canReopen(const Workbench& bench) const { return last_.canReopen(bench); }
    void proceed(const Pointer& pointer, const Workbench& bench);
    /// What the handle snaps to; null: nothing is dragged.
    const app::MovedSnap* snapped() const { return now_ && now_->snap ? &*now_->snap : nullptr; }
    void finish(Workbench& bench);
    void accept(const app::GestureEnd& end, Workbench& bench);
    void cancel(Workbench& bench);
    void end(Workbench& bench); ///< cancels, and forgets the last step
    void reopen(Workbench& bench);
    clipping::Window target() const; ///< the selection's bounds after the drag
    std::optional<app::Gauge> gauge(const Workbench& bench) const;
    void paint(QPainter& painter, const Workbench& bench) const;

private:
    struct State {
        app::Handle handle;
        clipping::Window bounds;
        app::Point pressed; ///< where the pointer was at first
        app::ObjectRanges objects;
        app::GestureEnd end;
        Qt::KeyboardModifiers modifiers;
        std::optional<app::MovedSnap> snap{};
    };
    static app::Point handleOf(const State& state) // before the drag
    {
        return app::placeOf(state.handle, state.bounds);
    }
    static app::Point fixed(const State& state); ///< the point that stays
    static const app::GestureMeasure& measure(const State& state);
    static clipping::Window target(const State& state);
    static app::MovedSnap snap(const State& state, const app::Point& by, const Workbench& bench);

    std::optional<State> now_;
    State done_{}; ///< the gesture of the last step
    LastStep last_;
};

} // namespace ui
