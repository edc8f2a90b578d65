// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/tool.h"

namespace ui {

/// The line whose ends are handles: the only selected object or, with nothing selected, the
/// inspected line; if the whole object is this line, and it may be edited.
std::optional<clipping::Segment> lineWithHandles(const app::Session& session);

/// Dragging an end of that line.
class EndDrag {
public:
    enum class End : std::uint8_t { A, B };
    static std::optional<End> endAt(const app::Point& screen, const Workbench& bench);

    bool going() const { return line_.has_value(); }
    void start(End end, const Pointer& pointer, Workbench& bench);
    void proceed(const Pointer& pointer, Workbench& bench);
    bool finish(const Pointer& pointer, Workbench& bench);  ///< one step; false: it was a click
    void accept(const app::Point& point, Workbench& bench); ///< ends it at a typed point
    void cancel(Workbench& bench);
    /// The length and the angle of the line, seen from its other end.
    std::optional<app::Gauge> gauge(const Workbench& bench) const;
    void paint(QPainter& painter, const Workbench& bench) const;

private:
    clipping::Segment movedTo(const app::Point& point) const;

    std::optional<clipping::Segment> line_; ///< as it was at the start
    End end_ = End::A;
    app::Point pressed_{}; ///< on the screen
    bool moved_ = false;
    clipping::Segment now_{};
};

} // namespace ui
