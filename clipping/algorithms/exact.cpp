// SPDX-License-Identifier: MIT
//
// Exact, our own algorithm: it makes no wrong decision on any finite input, and every new
// coordinate is the exact one, rounded once. The result is therefore unique: it depends neither on
// the order of the ends nor on the instruction set.
//
// A segment that is not wholly beyond one edge can enter only through the two edges it reaches
// first (the near ones, as it travels from a to b) and leave only through the other two (the far
// ones). It meets the window unless it passes a far edge of one axis before the near edge of the
// other; and it enters at the later of its two near edges and leaves at the earlier of its two far
// edges. Each of these decisions is the order in which the line passes an x and a y, that is, on
// which side of it a corner of the window lies. exact/bounds.h proves when floating point gives
// that order and the rounded coordinate; integer arithmetic decides the rest.

#include "clipping/algorithms/best.h"
#include "clipping/batch/sets.h"
#include "clipping/describe.h"
#include "clipping/exact/line_through.h"
#include "clipping/ieee_numbers.h"
#include "clipping/limits.h"
#include "clipping/polygon/uses.h"

namespace clipping {
struct Exact {
    static constexpr About about{
        .key = "exact",
        .abbreviation = "EX",
        .name = "Exact",
        .year = 2026,
        .idea = "Decide in floating point where a proved error bound allows it, and in exact "
                "integers elsewhere.",
        .ulps = 0.5,
    };

    static constexpr bool ours = true;     // no published form
    static constexpr bool unframed = true; // it handles all finite numbers itself
    static constexpr const auto* polygon = &exactPolygon;
    static constexpr const auto* polygonBySearch = &exactSearchedPolygon;

    template <class T>
    static std::size_t many(std::span<const BasicSegment<T>> in, const BasicWindow<T>& window,
                            std::span<BasicClipped<BasicSegment<T>>> out)
    {
        requireRoom(in.size(), out.size());
        return clipBatch(Batch<T>{in.data(), 0, in.size(), window, out.data()}).pieces;
    }

    static constexpr std::string_view correctedCode = R"(
if (x1 < xmin and x2 < xmin) or (x1 > xmax and x2 > xmax)  #besideX
  reject  #rejectX
if (y1 < ymin and y2 < ymin) or (y1 > ymax and y2 > ymax)  #besideY
  reject  #rejectY
x[1] = x1,  y[1] = y1,  x[2] = x2,  y[2] = y2
right = x1 < x2,  up = y1 < y2  #direction
xnear = right ? xmin : xmax,  xfar = right ? xmax : xmin  #levelsX
ynear = up ? ymin : ymax,  yfar = up ? ymax : ymin  #levelsY
enterX = right ? x1 < xnear : x1 > xnear  #enterX
enterY = up ? y1 < ynear : y1 > ynear  #enterY
leaveX = right ? x2 > xfar : x2 < xfar  #leaveX
leaveY = up ? y2 > yfar : y2 < yfar  #leaveY
if enterX and leaveY and order(xnear, yfar) > 0  #leavesYFirst
  reject  #rejectYFirst
if enterY and leaveX and order(xfar, ynear) < 0  #leavesXFirst
  reject  #rejectXFirst
if enterX and (not enterY or order(xnear, ynear) >= 0)  #end1AtX
  x[1] = xnear,  y[1] = yAt(xnear)  #move1ToX
else if enterY  #end1AtY
  y[1] = ynear,  x[1] = xAt(ynear)  #move1ToY
if leaveX and (not leaveY or order(xfar, yfar) <= 0)  #end2AtX
  x[2] = xfar,  y[2] = yAt(xfar)  #move2ToX
else if leaveY  #end2AtY
  y[2] = yfar,  x[2] = xAt(yfar)  #move2ToY
accept the line from x[1], y[1] to x[2], y[2]  #accept
)";
    /// The visible piece, and the edges at which it enters and leaves; NoEdge at an end of the
    /// input. (The coordinates alone do not tell the edge, because a new end may be rounded onto
    /// another edge as well.)
    template <class T>
    struct Piece {
        BasicSegment<T> visible;
        Edge enter = Edge::NoEdge, leave = Edge::NoEdge;
    };

    template <class T, class Step>
    static std::optional<Piece<T>> pieceOf(const BasicSegment<T>& s, const BasicWindow<T>& w,
                                           Step& step)
    {
        const T x1 = s.a.x, y1 = s.a.y, x2 = s.b.x, y2 = s.b.y;
        const T xmin = w.min.x, ymin = w.min.y, xmax = w.max.x, ymax = w.max.y;
        if (step.test("besideX", (x1 < xmin && x2 < xmin) || (x1 > xmax && x2 > xmax), Edge::Left,
                      Edge::Right))
            return step.reject("rejectX");
        if (step.test("besideY", (y1 < ymin && y2 < ymin) || (y1 > ymax && y2 > ymax), Edge::Bottom,
                      Edge::Top))
            return step.reject("rejectY");
        const bool right = step.set("right", x1 < x2), up = step.let("direction", "up", y1 < y2);
        const Edge nearX = right ? Edge::Left : Edge::Right,
                   farX = right ? Edge::Right : Edge::Left;
        const Edge nearY = up ? Edge::Bottom : Edge::Top, farY = up ? Edge::Top : Edge::Bottom;
        const T xnear = step.set("xnear", right ? xmin : xmax);
        const T xfar = step.let("levelsX", "xfar", right ? xmax : xmin);
        const T ynear = step.set("ynear", up ? ymin : ymax);
        const T yfar = step.let("levelsY", "yfar", up ? ymax : ymin);
        const bool enterX = step.let("enterX", "enterX", right ? x1 < xnear : x1 > xnear, nearX);
        const bool enterY = step.let("enterY", "enterY", up ? y1 < ynear : y1 > ynear, nearY);
        const bool leaveX = step.let("leaveX", "leaveX", right ? x2 > xfar : x2 < xfar, farX);
        const bool leaveY = step.let("leaveY", "leaveY", up ? y2 > yfar : y2 < yfar, farY);

        const LineThrough line(s);
        if (step.test("leavesYFirst", enterX && leaveY && std::is_gt(line.order(xnear, yfar)),
                      farY))
            return step.reject("rejectYFirst");
        if (step.test("leavesXFirst", enterY && leaveX && std::is_lt(line.order(xfar, ynear)),
                      farX))
            return step.reject("rejectXFirst");
        Piece<T> piece{s};
        auto& [a, b] = piece.visible;
        if (step.test("end1AtX", enterX && (!enterY || std::is_gteq(line.order(xnear, ynear))),
                      nearX)) {
            a = {xnear, line.yAt(xnear)}, piece.enter = nearX;
            step.cut("move1ToX", 0, a, nearX);
        } else if (step.test("end1AtY", enterY, nearY)) {
            a = {line.xAt(ynear), ynear}, piece.enter = nearY;
            step.cut("move1ToY", 0, a, nearY);
        }
        if (step.test("end2AtX", leaveX && (!leaveY || std::is_lteq(line.order(xfar, yfar))),
                      farX)) {
            b = {xfar, line.yAt(xfar)}, piece.leave = farX;
            step.cut("move2ToX", 1, b, farX);
        } else if (step.test("end2AtY", leaveY, farY)) {
            b = {line.xAt(yfar), yfar}, piece.leave = farY;
            step.cut("move2ToY", 1, b, farY);
        }
        step.accept("accept", piece.visible);
        return piece;
    }

    template <class T, class Step>
    static std::optional<BasicSegment<T>> corrected(const BasicSegment<T>& s,
                                                    const BasicWindow<T>& w, Step&& step)
    {
        const auto piece = pieceOf(s, w, step);
        return piece ? std::optional(piece->visible) : std::nullopt;
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
        Unwatched step;
        if (!withinContract(s, window))
            continue;
        if (const auto piece = Exact::pieceOf(s, window, step))
            out[visible++] = {piece->visible, indices[i], cutAt(piece->enter, piece->leave)};
    }
    return visible;
}
template std::size_t clipOneByOne(const Segment*, const std::uint32_t*, std::size_t, const Window&,
                                  Clipped*);
template std::size_t clipOneByOne(const BasicSegment<float>*, const std::uint32_t*, std::size_t,
                                  const BasicWindow<float>&, BasicClipped<BasicSegment<float>>*);

const Functions<Segment, Window> exactWindow = uses<Exact, Form::Corrected>;
const Functions<BasicSegment<float>, BasicWindow<float>> exactFloats =
    uses<Exact, Form::Corrected, float>;

template Algorithm describe<Exact>();

} // namespace clipping
