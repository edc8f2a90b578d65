// SPDX-License-Identifier: MIT
//
// Exact, ours: no wrong decision on any finite input, and every new coordinate is the true one,
// rounded once. The answer is therefore unique: it does not depend on which end comes first, nor on
// the instructions that computed it.
//
// A segment that is not wholly beyond one edge can enter only through the two edges it reaches
// first (the near ones, as it travels from a to b) and leave only through the other two (the far
// ones). It meets the window unless it passes a far edge of one axis before the near edge of the
// other; and of two edges to enter by, the later counts, of two to leave by, the earlier. Each of
// these decisions is the order in which the line passes an x and a y, that is, on which side of it
// a corner of the window lies. exact/bounds.h proves when floating point gives that order and the
// rounded coordinate; whole numbers settle the rest.

#include "clipping/batch/sets.h"
#include "clipping/describe.h"
#include "clipping/exact/line.h"
#include "clipping/ieee_numbers.h"

namespace clipping {
namespace {

/// The double in which coordinates of type T are computed with, and the way there and back.
template <class T>
struct Computing {
    using Number = double;
    using Target = T;
    static constexpr double from(T x) { return x; }
    static constexpr T to(double x) { return static_cast<T>(x); }
};
template <class T>
struct Computing<Counted<T>> {
    using Number = Counted<double>;
    using Target = T;
    static constexpr Number from(Counted<T> x) { return Number(x.value()); }
    static constexpr Counted<T> to(Number x) { return Counted<T>(static_cast<T>(x.value())); }
};

/// The line through a segment's ends.
template <class T>
struct LineThrough {
    using Numbers = Computing<T>;
    typename Numbers::Number ax, ay, bx, by;

    explicit LineThrough(const BasicSegment<T>& s)
        : ax(Numbers::from(s.a.x)), ay(Numbers::from(s.a.y)), bx(Numbers::from(s.b.x)),
          by(Numbers::from(s.b.y))
    {
    }
    std::strong_ordering passes(T x, T y) const
    {
        return order(ax, ay, bx, by, Numbers::from(x), Numbers::from(y));
    }
    glm::vec<2, T> at(T x) const
    {
        return {x,
                Numbers::to(crossing<typename Numbers::Target>(ax, ay, bx, by, Numbers::from(x)))};
    }
    glm::vec<2, T> atHeight(T y) const
    {
        return {Numbers::to(crossing<typename Numbers::Target>(ay, ax, by, bx, Numbers::from(y))),
                y};
    }
};

} // namespace

struct Exact {
    static constexpr About about{
        .key = "exact",
        .abbreviation = "EX",
        .name = "Exact",
        .year = 2026,
        .idea =
            "Let a proved bound say when floating point is right, and ask whole numbers elsewhere.",
        .ulps = 0.5,
    };

    static constexpr bool ours = true; // nothing was published but this

    template <class T>
    static std::size_t many(std::span<const BasicSegment<T>> in, const BasicWindow<T>& window,
                            std::span<BasicClipped<BasicSegment<T>>> out)
    {
        assert(out.size() >= in.size());
        return clipBatch(Batch<T>{in.data(), 0, in.size(), window, out.data()}).pieces;
    }

    template <Form, class T, class Watch>
    static std::optional<BasicSegment<T>> clip(const BasicSegment<T>& s, const BasicWindow<T>& w,
                                               Watch&& watch)
    {
        const auto piece = pieceOf(s, w, watch);
        return piece ? std::optional(piece->visible) : std::nullopt;
    }

    /// What is visible, and the edges by which it enters and leaves; None where it keeps an end.
    /// (Where a new end is rounded onto another edge as well, its coordinates do not tell.)
    template <class T>
    struct Piece {
        BasicSegment<T> visible;
        Edge enter = Edge::None, leave = Edge::None;
    };

    template <class T, class Watch>
    static std::optional<Piece<T>> pieceOf(const BasicSegment<T>& s, const BasicWindow<T>& w,
                                           Watch& watch)
    {
        const auto& [a, b] = s;
        if ((a.x < w.min.x && b.x < w.min.x) || (a.x > w.max.x && b.x > w.max.x)
            || (a.y < w.min.y && b.y < w.min.y) || (a.y > w.max.y && b.y > w.max.y)) {
            watch("reject", 1, s, Edge::None);
            return std::nullopt;
        }
        watch("no", 1, s, Edge::None);
        const bool right = a.x < b.x, up = a.y < b.y;
        const T nearX = right ? w.min.x : w.max.x, farX = right ? w.max.x : w.min.x;
        const T nearY = up ? w.min.y : w.max.y, farY = up ? w.max.y : w.min.y;
        const bool enterX = right ? a.x < nearX : a.x > nearX;
        const bool enterY = up ? a.y < nearY : a.y > nearY;
        const bool leaveX = right ? b.x > farX : b.x < farX;
        const bool leaveY = up ? b.y > farY : b.y < farY;

        watch("sides", 4, s, Edge::None, Named{"enterX", enterX}, Named{"enterY", enterY},
              Named{"leaveX", leaveX}, Named{"leaveY", leaveY});

        const LineThrough line(s);
        Piece<T> piece{s};
        BasicSegment<T>& visible = piece.visible;
        const auto test = [&](bool holds, int number, Edge edge) {
            watch(yesOrNo(holds), number, visible, edge);
            return holds;
        };
        const auto isMissed = [&](bool misses, int number, Edge edge) {
            watch(misses ? "reject" : "no", number, s, edge);
            return misses;
        };
        const Edge edgeNearX = right ? Edge::Left : Edge::Right;
        const Edge edgeFarX = right ? Edge::Right : Edge::Left;
        const Edge edgeNearY = up ? Edge::Bottom : Edge::Top;
        const Edge edgeFarY = up ? Edge::Top : Edge::Bottom;
        if (isMissed(enterX && leaveY && std::is_gt(line.passes(nearX, farY)), 5, edgeFarY)
            || isMissed(enterY && leaveX && std::is_lt(line.passes(farX, nearY)), 6, edgeFarX))
            return std::nullopt;
        if (test(enterX && (!enterY || std::is_gteq(line.passes(nearX, nearY))), 7, edgeNearX)) {
            visible.a = line.at(nearX), piece.enter = edgeNearX;
            watch("cut", 8, visible, edgeNearX);
        } else if (test(enterY, 9, edgeNearY)) {
            visible.a = line.atHeight(nearY), piece.enter = edgeNearY;
            watch("cut", 10, visible, edgeNearY);
        }
        if (test(leaveX && (!leaveY || std::is_lteq(line.passes(farX, farY))), 11, edgeFarX)) {
            visible.b = line.at(farX), piece.leave = edgeFarX;
            watch("cut", 12, visible, edgeFarX);
        } else if (test(leaveY, 13, edgeFarY)) {
            visible.b = line.atHeight(farY), piece.leave = edgeFarY;
            watch("cut", 14, visible, edgeFarY);
        }
        watch("accept", 15, visible, Edge::None);
        return piece;
    }
};

template <class T>
std::size_t clipOneByOne(const BasicSegment<T>* segments, const std::uint32_t* indices,
                         std::size_t count, const BasicWindow<T>& window,
                         BasicClipped<BasicSegment<T>>* out)
{
    std::size_t visible = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const BasicSegment<T>& s = segments[indices[i]];
        Unwatched watch;
        if (!withinContract(s, window))
            continue;
        if (const auto piece = Exact::pieceOf(s, window, watch))
            out[visible++] = {piece->visible, indices[i], cutAt(piece->enter, piece->leave)};
    }
    return visible;
}
template std::size_t clipOneByOne(const Segment*, const std::uint32_t*, std::size_t, const Window&,
                                  Clipped*);
template std::size_t clipOneByOne(const BasicSegment<float>*, const std::uint32_t*, std::size_t,
                                  const BasicWindow<float>&, BasicClipped<BasicSegment<float>>*);

template Algorithm describe<Exact>();

} // namespace clipping
