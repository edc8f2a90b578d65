// SPDX-License-Identifier: MIT
//
// Liang-Barsky (1984).
//
//   Y.-D. Liang, B. A. Barsky: A New Concept and Method for Line Clipping.
//   ACM Transactions on Graphics 3(1), 1984, 1-22.
//
// Corrected: a new end takes the coordinate of the edge that cut it, and its other coordinate is
// held inside the window; a single common point is the same point at both ends.

#include "clipping/along.h"
#include "clipping/box/uses.h"
#include "clipping/describe.h"

namespace clipping {

struct LiangBarsky {
    static constexpr About about{
        .key = "liang-barsky",
        .abbreviation = "LB",
        .name = "Liang-Barsky",
        .year = 1984,
        .idea =
            "Walk along the segment from 0 to 1, and let each edge raise the start or lower the "
            "stop.",
        .ulps = 24, // README.md, "How far off"
    };
    static constexpr auto box = &liangBarskyBox;
    static constexpr bool endless = true; // lines and rays too

    /// The part of the segment that is left: from `start` to `stop`, and the edges that said so.
    template <class T>
    struct Part {
        T start, stop;
        Edge startEdge = Edge::None, stopEdge = Edge::None;
    };

    /// Cuts the part at one edge; p is how fast the segment leaves that edge's half-plane, q how
    /// far its first end is from leaving it. False: nothing is left.
    template <class T, class Watch>
    static constexpr bool cut(Part<T>& part, T p, T q, Edge edge, const BasicSegment<T>& s,
                              Watch& watch)
    {
        watch("p and q", 4, s, edge, Named{"p", p}, Named{"q", q});
        if (p < T(0)) {
            watch("yes", 5, s, edge, Named{"p", p});
            const T r = q / p;
            watch("r", 6, s, edge, Named{"p", p}, Named{"q", q}, Named{"r", r});
            if (r > part.stop)
                return watch("reject", 7, s, edge, Named{"r", r}, Named{"u1", part.stop}), false;
            watch("no", 7, s, edge, Named{"r", r}, Named{"u1", part.stop});
            if (r > part.start) {
                watch("yes", 8, s, edge, Named{"r", r}, Named{"u0", part.start});
                part.start = r, part.startEdge = edge;
                watch("start", 9, s, edge, Named{"u0", part.start});
            } else
                watch("no", 8, s, edge, Named{"r", r}, Named{"u0", part.start});
        } else if (p > T(0)) {
            watch("no", 5, s, edge, Named{"p", p});
            watch("yes", 10, s, edge, Named{"p", p});
            const T r = q / p;
            watch("r", 11, s, edge, Named{"p", p}, Named{"q", q}, Named{"r", r});
            if (r < part.start)
                return watch("reject", 12, s, edge, Named{"r", r}, Named{"u0", part.start}), false;
            watch("no", 12, s, edge, Named{"r", r}, Named{"u0", part.start});
            if (r < part.stop) {
                watch("yes", 13, s, edge, Named{"r", r}, Named{"u1", part.stop});
                part.stop = r, part.stopEdge = edge;
                watch("stop", 14, s, edge, Named{"u1", part.stop});
            } else
                watch("no", 13, s, edge, Named{"r", r}, Named{"u1", part.stop});
        } else {
            watch("no", 5, s, edge, Named{"p", p});
            watch("no", 10, s, edge, Named{"p", p});
            if (q < T(0))
                return watch("reject", 15, s, edge, Named{"q", q}), false;
            watch("no", 15, s, edge, Named{"q", q});
        }
        return true;
    }

    template <Form form, Reach reach = Reach::Bounded, class T, class Watch>
    static constexpr std::optional<BasicSegment<T>> clip(const BasicSegment<T>& s,
                                                         const BasicWindow<T>& w, Watch&& watch)
    {
        Part<T> part{beginning<reach, T>(), ending<reach, T>()};
        const T dx = s.b.x - s.a.x;
        if (!cut(part, -dx, s.a.x - w.min.x, Edge::Left, s, watch)
            || !cut(part, dx, w.max.x - s.a.x, Edge::Right, s, watch))
            return std::nullopt;
        const T dy = s.b.y - s.a.y;
        if (!cut(part, -dy, s.a.y - w.min.y, Edge::Bottom, s, watch)
            || !cut(part, dy, w.max.y - s.a.y, Edge::Top, s, watch))
            return std::nullopt;

        BasicSegment<T> visible = s;
        if (reach != Reach::Bounded || part.stop < T(1)) {
            watch("yes", 16, s, part.stopEdge, Named{"u1", part.stop});
            visible.b = along<form>(s, {dx, dy}, part.stop, part.stopEdge, w);
            watch("cut b", 17, visible, part.stopEdge, Named{"u1", part.stop});
        } else {
            watch("no", 16, s, part.stopEdge, Named{"u1", part.stop});
            if constexpr (form == Form::Corrected)
                visible.b = clamped(s.b, w);
        }
        if (reach == Reach::BothWays || part.start > T(0)) {
            watch("yes", 18, visible, part.startEdge, Named{"u0", part.start});
            visible.a = along<form>(s, {dx, dy}, part.start, part.startEdge, w);
            if constexpr (form == Form::Corrected)
                if (part.stopEdge != Edge::None && part.start == part.stop)
                    visible.a = visible.b;
            watch("cut a", 19, visible, part.startEdge, Named{"u0", part.start});
        } else {
            watch("no", 18, visible, part.startEdge, Named{"u0", part.start});
            if constexpr (form == Form::Corrected)
                visible.a = clamped(s.a, w);
        }
        watch("accept", 20, visible, Edge::None);
        return visible;
    }
};

template Algorithm describe<LiangBarsky>();

} // namespace clipping
