// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/picture.h"

namespace app {

/// A line, or the part of one that is in the view.
struct SeenPart {
    clipping::Segment segment;
    bool cutA, cutB; ///< these ends are not the stroke's own
};

/// Makes the chains of strokes, for the last coat of a plate: parts that follow each other are one
/// chain.
class Chaining {
public:
    Chaining(Plate& plate, const View& view);

    /// Of what follows, in pixels; empty: solid.
    void setDashes(std::vector<double> pattern);
    bool isDashed() const { return !pattern_.empty(); }

    /// Goes on with the chain, or ends it and begins another one. `phase()` says where in the dash
    /// pattern that begins, in user units; it is asked only then, and only for dashed strokes.
    template <class Phase>
    void add(const SeenPart& part, const Phase& phase);
    /// Nothing more follows: the stroke has its own end there.
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
    // The chain being made; its points are the last of plate_.points.
    struct Open {
        Point last;                    // in the drawing
        std::optional<QPointF> unsaid; // a point too close to the one before it
        double phase;                  // length of the path before the chain
        bool capAtStart;
    };

    void begin(const SeenPart& part, double phase);
    void proceed(const Point& to);
    void finish(bool capAtEnd);
    void finishDashed(bool capAtEnd);
    void push(const Chain& chain);
    bool liesOnAnother(const Chain& chain);

    Plate& plate_;
    const View& view_;
    std::optional<Open> open_;
    std::uint32_t openAt_ = 0; // its first point
    std::vector<double> pattern_;
    std::vector<std::uint32_t> recent_; // chains, by a hash of their points
};

template <class Phase>
void Chaining::add(const SeenPart& part, const Phase& phase)
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
