// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/last_step.h"

#include <array>

namespace ui {

/// The line whose ends are handles: the only selected object or, with nothing selected, the
/// inspected line; if the whole object is this line, and it may be edited.
std::optional<clipping::Segment> lineWithHandles(const app::Session& session);

/// Dragging an end of that line; with Alt its middle stays. Typed numbers hold, and change what was
/// just done.
class EndDrag {
public:
    enum class End : std::uint8_t { A, B };
    static std::optional<End> endAt(const app::Point& screen, const Workbench& bench);
    /// The places of its handles on the screen: its ends, beside which a short line is seen.
    static std::array<app::Point, 2> handles(const Workbench& bench); ///< there is such a line

    bool going() const { return now_.has_value(); }
    std::optional<std::size_t> object() const;       ///< whose end is dragged
    bool corrects() const { return last_.isOpen(); } ///< the last step is open again
    bool canReopen(const Workbench& bench) const { return last_.canReopen(bench); }
    void start(End end, const Pointer& pointer, Workbench& bench);
    void proceed(const Pointer& pointer, Workbench& bench);
    bool finish(const Pointer& pointer, Workbench& bench);  ///< one step; false: it was a click
    void accept(const app::Point& point, Workbench& bench); ///< ends it at a typed point
    void cancel(Workbench& bench);
    void end(Workbench& bench); ///< cancels, and forgets the last step
    void reopen(Workbench& bench);
    /// The length and the angle of the line, seen from its other end or its middle.
    std::optional<app::Gauge> gauge(const Workbench& bench) const;
    void paint(QPainter& painter, const Workbench& bench) const;

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
    LastStep last_;
};

} // namespace ui
