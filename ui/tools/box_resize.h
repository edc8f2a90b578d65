// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object_ranges.h"
#include "ui/tools/drag.h"
#include "ui/tools/frame_drag.h"

namespace ui {

/// Resizes the selection by a handle of its frame, which snaps. Shift keeps the proportions, Alt
/// the centre; typed numbers hold, and change what was just done.
class BoxResize final : public Drag {
public:
    void start(const HeldHandle& held, const Pointer& pressed, const Workbench& bench);
    bool going() const override { return now_.has_value(); }
    void proceed(const Pointer& pointer, Workbench& bench) override;
    bool finish(const Pointer& pointer, Workbench& bench) override;
    void cancel(Workbench& bench) override;
    void paint(QPainter& painter, const Workbench& bench) const override;
    app::WindowFrame target() const { return target(*now_); } ///< the frame after the drag
    std::optional<app::Gauge> gauge(const Workbench& bench) const override;
    void accept(const app::GestureEnd& end, Workbench& bench) override;
    void reopen(Workbench& bench) override;
    const app::MovedSnap* snapped() const override
    {
        return now_ && now_->snap ? &*now_->snap : nullptr;
    }

private:
    struct State {
        HeldHandle held;
        app::Point pressed; ///< where the pointer was at first
        app::ObjectRanges objects;
        app::GestureEnd end;
        Qt::KeyboardModifiers modifiers;
        std::optional<app::MovedSnap> snap{};
    };
    static app::WindowFrame target(const State& state);
    static app::MovedSnap snap(const State& state, const app::Point& by, const Workbench& bench);

    std::optional<State> now_;
    State done_{}; ///< the gesture of the last step
};

} // namespace ui
