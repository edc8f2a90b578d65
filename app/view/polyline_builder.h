// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/draw_list.h"
#include "app/view/view.h"

#include <optional>
#include <vector>

namespace app {

/// The part of a line that lies in the view.
struct SeenPart {
    clipping::Segment segment;
    bool cutA, cutB; ///< whether the end was made by clipping
};

/// Joins consecutive parts of strokes into polylines, for the last draw command of
/// a draw list.
class PolylineBuilder {
public:
    PolylineBuilder(DrawList& drawList, const View& view);

    /// The dash pattern of the following parts, in pixels; empty: solid.
    void setDashes(std::vector<double> pattern);
    bool isDashed() const { return !pattern_.empty(); }

    /// Appends to the current polyline, or ends it and begins another one. `phase()` returns the
    /// offset into the dash pattern, in user units, at the beginning of a polyline; it is called
    /// only there, and only for dashed strokes.
    template <class Phase>
    void add(const SeenPart& part, const Phase& phase);
    /// Ends the polyline at an end of the stroke itself.
    void end()
    {
        if (open_)
            finish(true);
    }
    QPointF onScreen(const Point& p) const
    {
        const Point s = view_.toScreen(p);
        return {s.x, s.y};
    }

private:
    // The current polyline; its points are the last of drawList_.points.
    struct Open {
        Point last;                    // in document coordinates
        std::optional<QPointF> unsaid; // held back: too close to the one before
        double phase;                  // length of the path before the polyline
        bool capAtStart;
    };

    void begin(const SeenPart& part, double phase);
    void proceed(const Point& to);
    void finish(bool capAtEnd);
    void finishDashed();
    void push(const Polyline& polyline);
    bool liesOnAnother(const Polyline& polyline);

    DrawList& drawList_;
    const View& view_;
    std::optional<Open> open_;
    std::uint32_t openAt_ = 0; // its first point
    std::vector<double> pattern_;
    std::vector<std::uint32_t> recent_; // recent polylines by a hash of their points
};

template <class Phase>
void PolylineBuilder::add(const SeenPart& part, const Phase& phase)
{
    if (open_ && (open_->last != part.segment.a || part.cutA))
        finish(true);
    if (!open_)
        begin(part, isDashed() ? phase() : 0);
    proceed(part.segment.b);
    if (part.cutB)
        finish(false);
}

} // namespace app
