// SPDX-License-Identifier: MIT
//
// Matthes-Drakopoulos (2019) for infinite lines and rays. An end at infinity, before a or behind b,
// is beyond the sides that the line comes from or goes to. Steps have the labels of the
// corrected pseudo-code for segments.

#include "clipping/algorithms/lines_and_rays/uses.h"
#include "clipping/clamped.h"
#include "clipping/describe.h"
#include "clipping/ieee_numbers.h"

namespace clipping {
namespace {

struct OnLinesAndRays {
    /// The side on one axis at which the line, with direction d on this axis, goes to infinity;
    /// `backwards`: in the opposite direction.
    template <class T>
    static constexpr Edge side(T d, bool backwards, Edge low, Edge high)
    {
        return d == T(0) ? Edge::NoEdge : (d > T(0)) != backwards ? high : low;
    }

    /// Whether the line or ray through a and b is wholly below `low` or above `high` on an axis.
    template <Reach reach, class T>
    static constexpr bool missed(T a, T b, T low, T high)
    {
        if constexpr (reach == Reach::OneWay)
            return (a < low && b <= a) || (a > high && b >= a);
        else
            return a == b && (a < low || a > high);
    }

    /// Moves end i from `from` to the edges it is beyond; `edge` becomes the last of them.
    template <bool infinite, class T, class Step>
    static constexpr glm::vec<2, T> pushed(int i, const glm::vec<2, T>& from,
                                           const glm::vec<2, T>& d, const BasicWindow<T>& w,
                                           Edge& edge, Step& step)
    {
        const bool backwards = infinite && i == 0;
        glm::vec<2, T> p = from;
        T rise(0);
        edge = infinite ? side(d.x, backwards, Edge::Left, Edge::Right)
               : step.test("left", p.x < w.min.x, Edge::Left)   ? Edge::Left
               : step.test("right", p.x > w.max.x, Edge::Right) ? Edge::Right
                                                                : Edge::NoEdge;
        const bool moved = edge != Edge::NoEdge;
        if (moved) {
            const T x = edge == Edge::Left ? w.min.x : w.max.x;
            rise = step.let(edge == Edge::Left ? "riseToLeft" : "riseToRight", "rise",
                            d.y * (x - from.x) / d.x, edge);
            p = {x, rise + from.y};
            step.cut(edge == Edge::Left ? "toLeft" : "toRight", i, p, edge);
        }
        const T low = w.min.y, high = w.max.y;
        const Edge next =
            infinite && !moved ? side(d.y, backwards, Edge::Bottom, Edge::Top)
            : step.test("bottom", moved ? rise < low - from.y : p.y < low, Edge::Bottom)
                ? Edge::Bottom
            : step.test("top", moved ? rise > high - from.y : p.y > high, Edge::Top) ? Edge::Top
                                                                                     : Edge::NoEdge;
        if (next == Edge::NoEdge)
            return p;
        edge = next;
        const T y = next == Edge::Bottom ? low : high;
        const T run = step.let(next == Edge::Bottom ? "runToBottom" : "runToTop", "run",
                               d.x * (y - from.y) / d.y, next);
        p = {run + from.x, y};
        step.cut(next == Edge::Bottom ? "toBottom" : "toTop", i, p, next);
        return p;
    }

    template <Reach reach, class T, class Step>
    static constexpr std::optional<BasicSegment<T>> clip(const BasicSegment<T>& s,
                                                         const BasicWindow<T>& w, Step&& step)
    {
        const auto& [a, b] = s;
        if (step.test("besideX", missed<reach>(a.x, b.x, w.min.x, w.max.x), Edge::Left,
                      Edge::Right))
            return step.reject("rejectX");
        if (step.test("besideY", missed<reach>(a.y, b.y, w.min.y, w.max.y), Edge::Bottom,
                      Edge::Top))
            return step.reject("rejectY");
        const glm::vec<2, T> d{b.x - a.x, b.y - a.y};
        Edge edgeOfA, edgeOfB;
        const auto p = pushed<reach == Reach::BothWays>(0, a, d, w, edgeOfA, step);
        const auto q = pushed<true>(1, b, d, w, edgeOfB, step);
        if (step.test("missed",
                      (p.x < w.min.x && q.x < w.min.x) || (p.x > w.max.x && q.x > w.max.x),
                      Edge::Left, Edge::Right))
            return step.reject("reject");
        return step.accept(
            "accept", BasicSegment<T>{clampedAlong(edgeOfA, p, w), clampedAlong(edgeOfB, q, w)});
    }
};

} // namespace

const Functions<Line, Window, Segment> matthesDrakopoulosLine =
    lineOrRayUses<OnLinesAndRays, Reach::BothWays>;
const Functions<Ray, Window, Segment> matthesDrakopoulosRay =
    lineOrRayUses<OnLinesAndRays, Reach::OneWay>;

} // namespace clipping
