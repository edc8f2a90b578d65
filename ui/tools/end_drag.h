// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/drag.h"

#include <array>

namespace ui {

/// The line whose ends are handles: the only selected object or, with nothing selected, the
/// inspected line; if the whole object is this line, and it may be edited.
std::optional<clipping::Segment> lineWithHandles(const app::Session& session);

/// Dragging an end of that line; with Alt its middle stays. Typed numbers hold, and change what was
/// just done.
class EndDrag final : public Drag {
public:
    enum class End : std::uint8_t { A, B };
    static std::optional<End> endAt(const app::Point& screen, const Workbench& bench);
    /// The places of its handles on the screen: its ends, beside which a short line is seen.
    static std::array<app::Point, 2> handles(const Workbench& bench); ///< there is such a line

    void start(End end, const Pointer& pointer, Workbench& bench);
    bool going() const override { return now_.has_value(); }
    void proceed(const Pointer& pointer, Workbench& bench) override;
    bool finish(const Pointer& pointer, Workbench& bench) override;
    void cancel(Workbench& bench) override;
    void paint(QPainter& painter, const Workbench& bench) const override;
    /// The length and the angle of the line, seen from its other end or its middle.
    std::optional<app::Gauge> gauge(const Workbench& bench) const override;
    void accept(const app::GestureEnd& to, Workbench& bench) override;
    void reopen(Workbench& bench) override;
    void limit(app::SnapQuery& query) const override { query.without = {now_->object}; }

private:
    struct State {
        clipping::Segment line;               ///< as it was at the start
        std::optional<std::size_t> inspected; ///< the line of the scene that was inspected
        std::size_t object;                   ///< whose line it is
        End end;
        app::Point pressed; ///< on the screen
        bool moved = false;
        Qt::KeyboardModifiers modifiers{};
        app::Point to{}; ///< where the end is
    };
    static app::Point fixed(const State& state); ///< the point of the line that stays
    static clipping::Segment moved(const State& state);

    std::optional<State> now_;
    State done_{}; ///< the gesture of the last step
};

} // namespace ui
