// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/trace.h"

#include <algorithm>
#include <array>
#include <type_traits>

namespace clipping {

/// The symmetries of the plane that map axes to axes: of a point, of a window, and the one that
/// undoes it. All are exact. P is a vector of any number.
struct HalfTurn {
    template <class P>
    static constexpr P of(const P& p)
    {
        return {-p.x, -p.y};
    }
    template <class W>
    static constexpr W window(const W& w)
    {
        return {of(w.max), of(w.min)};
    }
    using Inverse = HalfTurn;
};
struct MirrorInX {
    template <class P>
    static constexpr P of(const P& p)
    {
        return {p.x, -p.y};
    }
    template <class W>
    static constexpr W window(const W& w)
    {
        return {{w.min.x, -w.max.y}, {w.max.x, -w.min.y}};
    }
    using Inverse = MirrorInX;
};
struct MirrorInDiagonal {
    template <class P>
    static constexpr P of(const P& p)
    {
        return {-p.y, -p.x};
    }
    template <class W>
    static constexpr W window(const W& w)
    {
        return {of(w.max), of(w.min)};
    }
    using Inverse = MirrorInDiagonal;
};
struct ThreeQuarterTurn;
struct QuarterTurn { // clockwise
    template <class P>
    static constexpr P of(const P& p)
    {
        return {p.y, -p.x};
    }
    template <class W>
    static constexpr W window(const W& w)
    {
        return {{w.min.y, -w.max.x}, {w.max.y, -w.min.x}};
    }
    using Inverse = ThreeQuarterTurn;
};
struct ThreeQuarterTurn {
    template <class P>
    static constexpr P of(const P& p)
    {
        return {-p.y, p.x};
    }
    template <class W>
    static constexpr W window(const W& w)
    {
        return {{-w.max.y, w.min.x}, {-w.min.y, w.max.x}};
    }
    using Inverse = QuarterTurn;
};

/// Where a symmetry takes an edge of the window.
template <class Symmetry>
constexpr Edge edgeIn(Edge edge)
{
    constexpr std::array<glm::ivec2, 5> outward{{{0, 0}, {-1, 0}, {1, 0}, {0, -1}, {0, 1}}};
    const auto wanted = Symmetry::of(outward[static_cast<std::size_t>(edge)]);
    return static_cast<Edge>(std::find(outward.begin(), outward.end(), wanted) - outward.begin());
}

/// Shows a watcher what happens in another frame as it is in its own. The way back is not counted.
template <class Symmetry, class Watch>
struct TurnedWatch {
    Watch& watch;
    template <class T, class... Values>
    void operator()(std::string_view what, int line, const BasicSegment<Counted<T>>& s, Edge edge,
                    const Values&... values) const
    {
        const BasicSegment<T> seen = plain(s);
        watch(what, line, counted(BasicSegment<T>{Symmetry::of(seen.a), Symmetry::of(seen.b)}),
              edgeIn<Symmetry>(edge), values...);
    }
};

/// What watches a procedure that runs in a frame which Symmetry turns back.
template <class Symmetry, class Watch>
constexpr auto turnedWatch(Watch& watch)
{
    if constexpr (std::is_same_v<std::remove_cv_t<Watch>, Unwatched>)
        return Unwatched{};
    else
        return TurnedWatch<Symmetry, Watch>{watch};
}

} // namespace clipping
