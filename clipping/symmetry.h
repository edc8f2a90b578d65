// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/trace.h"

#include <algorithm>
#include <array>
#include <type_traits>

namespace clipping {

/// Symmetries of the plane that map axes to axes. Each maps points and windows exactly and names
/// its inverse. P is a vector of any number type.
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

/// The edge onto which a symmetry maps an edge of the window.
template <class Symmetry>
constexpr Edge edgeIn(Edge edge)
{
    constexpr std::array<glm::ivec2, 5> outward{{{0, 0}, {-1, 0}, {1, 0}, {0, -1}, {0, 1}}};
    const auto wanted = Symmetry::of(outward[static_cast<std::size_t>(edge)]);
    return static_cast<Edge>(std::find(outward.begin(), outward.end(), wanted) - outward.begin());
}

/// Reports the steps of a procedure that works in a transformed frame. Symmetry maps edges, new
/// ends and the procedure's variables back to the original frame; these mappings are not counted.
template <class Symmetry, class Step>
struct TurnedStep {
    Step& step;
    bool test(std::string_view label, bool condition, Edge edge) const
    {
        return step.test(label, condition, edgeIn<Symmetry>(edge));
    }
    template <class T>
    T let(std::string_view label, std::string_view name, T value, Edge edge = Edge::NoEdge) const
    {
        return step.let(label, name, value, edgeIn<Symmetry>(edge));
    }
    template <class T>
    T set(std::string_view name, T value) const
    {
        return step.set(name, value);
    }
    template <class T>
    void cut(std::string_view label, int end, T x, T y, Edge edge) const
    {
        set(end == 0 ? "x1" : "x2", x), set(end == 0 ? "y1" : "y2", y);
        cut(label, end, glm::vec<2, T>(x, y), edge);
    }
    template <class T>
    void cut(std::string_view label, int end, const glm::vec<2, Counted<T>>& to, Edge edge) const
    {
        step.cut(label, end, counted(glm::vec<2, T>(Symmetry::of(values(to)))),
                 edgeIn<Symmetry>(edge));
    }
    template <class T>
    void left(std::string_view label, const BasicSegment<Counted<T>>& segment) const
    {
        const BasicSegment<T> seen = plain(segment);
        step.left(label, counted(BasicSegment<T>{Symmetry::of(seen.a), Symmetry::of(seen.b)}));
    }
};

/// The step reporter for a procedure in a transformed frame, which Symmetry maps back.
template <class Symmetry, class Step>
constexpr auto turnedStep(Step& step)
{
    if constexpr (std::is_same_v<std::remove_cv_t<Step>, Unwatched>)
        return Unwatched{};
    else
        return TurnedStep<Symmetry, Step>{step};
}

} // namespace clipping
