// SPDX-License-Identifier: MIT
//
// Midpoint subdivision (1968).
//
//   R. F. Sproull, I. E. Sutherland: A Clipping Divider. Proceedings of the Fall Joint Computer
//   Conference 33, 1968, 765-775.
//
// Published: halve until a midpoint equals one of the two ends it lies between.
//
// Corrected: the points are integer multiples of 2^-53 of the segment (2^-24 in float), so 53
// halvings (24 in float) find each end for any input. A point's outcode compares the distance from
// `a` to the point with the distances to the edges, all of them accurate. Rounding is monotone,
// hence so are the outcodes: once the segment has come inside an edge, later points are inside it
// too. If the last two points are beyond different edges, the window lies between them. That is a
// contact, which halving alone would lose; it is also a contact if the two ends found are
// neighbouring points. A new end takes the coordinate of the edge that the next point is beyond,
// and is clamped to the window.
//
// Error: two points of the last step are 2^-53*D apart, 2 ulps; in README.md they take the place of
// the two differences in step 1, so its k = 24 holds here too. An outcode can be wrong within 3e, 6
// ulps: a contact of two ends is off by both steps, both outcodes and the 5 of an added distance, 4
// + 12 + 5 = 21. The same holds in three dimensions, where this is far below the k of
// box/README.md.

#include "clipping/clamped.h"
#include "clipping/describe.h"
#include "clipping/ieee_numbers.h"
#include "clipping/outcode.h"

#include <array>
#include <bit>
#include <limits>

namespace clipping {

struct MidpointSubdivision {
    static constexpr About about{
        .key = "midpoint-subdivision",
        .abbreviation = "MS",
        .name = "Midpoint subdivision",
        .year = 1968,
        .idea = "Halve the segment repeatedly, each time dropping the half that cannot contain the "
                "end that is sought, until nothing is left to halve.",
        .ulps = 24,
    };
    /// The cap of the published form; from 2^1024 to 2^-1074 it needs 2098 halvings.
    static constexpr int mostHalvings = 2200;

    /// An edge that a point with this outcode is beyond.
    static constexpr Edge edgeOf(unsigned code)
    {
        return static_cast<Edge>(std::countr_zero(code) + 1);
    }

    static constexpr std::string_view publishedCode = R"(
code1 = outcode(x1, y1),  code2 = outcode(x2, y2)  #codes
if code1 & code2 != 0000  #beyond
  reject  #rejectBeyond
x[1] = x1,  y[1] = y1,  x[2] = x2,  y[2] = y2
if code2 != 0000  #end2
  seek(x1, y1, code1, x2, y2, code2)  #seek2
  x[2] = xn,  y[2] = yn  #move2
if code1 != 0000  #end1
  seek(x2, y2, code2, x1, y1, code1)  #seek1
  x[1] = xn,  y[1] = yn  #move1
accept the line from x[1], y[1] to x[2], y[2]  #accept
seek(xn, yn, near, xf, yf, far):
  repeat
    if near & far != 0000  #bothBeyond
      reject  #reject
    give up after 2200 halvings  #giveUp
    xm = (xn + xf) * 0.5,  ym = (yn + yf) * 0.5  #middle
    if xm == xn and ym == yn or xm == xf and ym == yf  #noneLeft
      if near != 0000  #nearOutside
        reject  #rejectNear
      return
    M = outcode(xm, ym)  #code
    if M & far != 0000  #sameSide
      xf = xm,  yf = ym,  far = M  #nearHalf
    else
      xn = xm,  yn = ym,  near = M  #farHalf
)";
    /// A point with its outcode.
    template <class T>
    struct Point {
        glm::vec<2, T> at;
        unsigned code;
    };
    /// Two neighbouring points: the visible one nearest to the far end, and the next one towards
    /// the far end.
    template <class T>
    struct Found {
        Point<T> near, far;
    };

    /// Seeks the visible point nearest to `to`; `call` is the label of the call.
    template <class T, class Step>
    static constexpr std::optional<Found<T>> seek(std::string_view call, const Point<T>& from,
                                                  const Point<T>& to, const BasicWindow<T>& w,
                                                  Step& step)
    {
        T xn = step.set("xn", from.at.x), yn = step.set("yn", from.at.y);
        unsigned near = step.set("near", from.code);
        T xf = step.set("xf", to.at.x), yf = step.set("yf", to.at.y);
        unsigned far = step.let(call, "far", to.code);
        for (int halvings = 0;; ++halvings) {
            if (step.test("bothBeyond", (near & far) != 0))
                return step.reject("reject");
            if (halvings == mostHalvings)
                return step.giveUp("giveUp");
            const T xm = step.set("xm", (xn + xf) * T(0.5));
            const T ym = step.let("middle", "ym", (yn + yf) * T(0.5));
            if (step.test("noneLeft", (xm == xn && ym == yn) || (xm == xf && ym == yf))) {
                if (step.test("nearOutside", near != 0))
                    return step.reject("rejectNear");
                return Found<T>{{{xn, yn}, near}, {{xf, yf}, far}};
            }
            const unsigned M = step.let("code", "M", outcodeOf(glm::vec<2, T>(xm, ym), w));
            if (step.test("sameSide", (M & far) != 0)) {
                xf = step.set("xf", xm), yf = step.set("yf", ym);
                far = step.let("nearHalf", "far", M);
            } else {
                xn = step.set("xn", xm), yn = step.set("yn", ym);
                near = step.let("farHalf", "near", M);
            }
        }
    }

    template <class T, class Step>
    static constexpr std::optional<BasicSegment<T>> published(const BasicSegment<T>& s,
                                                              const BasicWindow<T>& w, Step&& step)
    {
        const unsigned code1 = step.set("code1", outcodeOf(s.a, w));
        const unsigned code2 = step.let("codes", "code2", outcodeOf(s.b, w));
        if (step.test("beyond", (code1 & code2) != 0))
            return step.reject("rejectBeyond");
        const Point<T> end1{s.a, code1}, end2{s.b, code2};
        BasicSegment<T> visible = s;
        if (step.test("end2", code2 != 0)) {
            const auto found = seek("seek2", end1, end2, w, step);
            if (!found)
                return std::nullopt;
            visible.b = found->near.at;
            step.cut("move2", 1, visible.b, edgeOf(found->far.code));
        }
        if (step.test("end1", code1 != 0)) {
            const auto found = seek("seek1", end2, end1, w, step);
            if (!found)
                return std::nullopt;
            visible.a = found->near.at;
            step.cut("move1", 0, visible.a, edgeOf(found->far.code));
        }
        return step.accept("accept", visible);
    }

    static constexpr std::string_view correctedCode = R"(
code1 = outcode(x1, y1),  code2 = outcode(x2, y2)  #codes
if code1 & code2 != 0000  #beyond
  reject  #rejectBeyond
x[1] = x1,  y[1] = y1,  x[2] = x2,  y[2] = y2
contact = false  #contact
if code1 | code2 != 0000  #outside
  dx = x2-x1,  toLeft = xmin-x1,  toRight = xmax-x1  #waysX
  dy = y2-y1,  toBottom = ymin-y1,  toTop = ymax-y1  #waysY
if code2 != 0000  #end2
  seek(0, code1, 1, code2)  #seek2
  place(n, near | far)  #place2
  x[2] = x,  y[2] = y,  last = n,  sides = near | far  #move2
  if near != 0000  #touches2
    x[1] = x,  y[1] = y,  contact = true  #contact2
if code1 != 0000 and not contact  #end1
  seek(1, code2, 0, code1)  #seek1
  contact = near != 0000  #touches1
  if code2 != 0000 and last - n <= 1/9007199254740992  #onePoint
    contact = true,  near = near | sides  #oneContact
  place(n, near | far)  #place1
  x[1] = x,  y[1] = y  #move1
  if contact  #isContact
    x[2] = x,  y[2] = y  #contact1
accept the line from x[1], y[1] to x[2], y[2]  #accept
seek(n, near, f, far):
  halvings = 0  #halvings
  while near & far == 0000 and halvings < 53  #goOn
    t = (n + f) * 0.5,  halvings = halvings + 1  #middle
    q = t*dx,  M = q < toLeft ? LEFT : q > toRight ? RIGHT : 0000  #codeX
    q = t*dy,  M = M | (q < toBottom ? BOTTOM : q > toTop ? TOP : 0000)  #codeY
    if M & far != 0000  #sameSide
      f = t,  far = M  #nearHalf
    else
      n = t,  near = M  #farHalf
  if near & far != 0000  #bothBeyond
    reject  #reject
place(t, s):
  in = t < 1,  x = in ? x1 + t*dx : x2,  y = in ? y1 + t*dy : y2  #point
  x = s & LEFT ? xmin : s & RIGHT ? xmax : held(x)  #sideX
  y = s & BOTTOM ? ymin : s & TOP ? ymax : held(y)  #sideY
)";
    /// The differences from a to b and to each edge of the window.
    template <class T, glm::length_t N>
    struct Ways {
        glm::vec<N, T> d, low, high;
    };
    /// Two points of the segment, as fractions of its length from a, with their outcodes. The end
    /// being sought lies between them.
    template <class T>
    struct Bracket {
        T near;
        unsigned nearCode;
        T far;
        unsigned farCode;
        constexpr unsigned codes() const { return nearCode | farCode; }
    };

    template <class T>
    struct DigitsOf : std::numeric_limits<T> {
    };
    template <class T>
    struct DigitsOf<Counted<T>> : std::numeric_limits<T> {
    };
    template <class T>
    /// Number of halvings until two points are neighbours.
    static constexpr int steps = DigitsOf<T>::digits;

    template <class T, glm::length_t N, class Step>
    static constexpr Ways<T, N> waysOf(const BasicSegment<T, N>& s, const BasicWindow<T, N>& w,
                                       Step& step)
    {
        constexpr std::array d{"dx", "dy", "dz"}, low{"toLeft", "toBottom", "toNear"},
            high{"toRight", "toTop", "toFar"};
        Ways<T, N> ways;
        for (glm::length_t k = 0; k < N; ++k) {
            ways.d[k] = step.set(d[k], s.b[k] - s.a[k]);
            ways.low[k] = step.set(low[k], w.min[k] - s.a[k]);
            ways.high[k] = step.let(labelOn(k, "waysX", "waysY"), high[k], w.max[k] - s.a[k]);
        }
        return ways;
    }

    /// Halves a bracket until its points are neighbours; returns nothing if both are beyond one
    /// edge. `call` is the label of the call.
    template <class T, glm::length_t N, class Step>
    static constexpr std::optional<Bracket<T>> seek(std::string_view call, Bracket<T> bracket,
                                                    const Ways<T, N>& ways, Step& step)
    {
        auto& [n, near, f, far] = bracket;
        step.set("n", n), step.set("near", near), step.set("f", f);
        step.let(call, "far", far);
        int halvings = step.let("halvings", "halvings", 0);
        while (step.test("goOn", (near & far) == 0 && halvings < steps<T>)) {
            const T t = step.set("t", (n + f) * T(0.5));
            step.let("middle", "halvings", ++halvings);
            unsigned M = 0;
            for (glm::length_t k = 0; k < N; ++k) {
                const T q = step.set("q", t * ways.d[k]);
                M |= sideBeyond(q, ways.low[k], ways.high[k]) << 2 * k;
                step.let(labelOn(k, "codeX", "codeY"), "M", M);
            }
            if (step.test("sameSide", (M & far) != 0)) {
                f = step.set("f", t);
                far = step.let("nearHalf", "far", M);
            } else {
                n = step.set("n", t);
                near = step.let("farHalf", "near", M);
            }
        }
        if (step.test("bothBeyond", (near & far) != 0))
            return step.reject("reject");
        return bracket;
    }

    /// The point found, with the coordinates of the edges that its outcodes name. `call` is the
    /// label of the call.
    template <class T, glm::length_t N, class Step>
    static constexpr glm::vec<N, T> place(std::string_view call, const Bracket<T>& found,
                                          const BasicSegment<T, N>& s, const BasicWindow<T, N>& w,
                                          const Ways<T, N>& ways, Step& step)
    {
        const T t = found.near;
        const unsigned sides = found.codes();
        constexpr std::array names{"x", "y", "z"};
        step.set("t", t), step.let(call, "s", sides);
        glm::vec<N, T> p = s.b;
        if (step.set("in", t < T(1)))
            for (glm::length_t k = 0; k < N; ++k)
                p[k] = s.a[k] + t * ways.d[k];
        step.set("x", p.x), step.let("point", "y", p.y);
        for (glm::length_t k = 0; k < N; ++k) {
            const unsigned side = sides >> 2 * k;
            p[k] = side & outcode::left    ? w.min[k]
                   : side & outcode::right ? w.max[k]
                                           : clamped(p[k], w.min[k], w.max[k]);
            step.let(labelOn(k, "sideX", "sideY"), names[k], p[k]);
        }
        return p;
    }

    template <class T, glm::length_t N, class Step>
    static constexpr std::optional<BasicSegment<T, N>>
    corrected(const BasicSegment<T, N>& s, const BasicWindow<T, N>& w, Step&& step)
    {
        const unsigned code1 = step.set("code1", outcodeOf(s.a, w));
        const unsigned code2 = step.let("codes", "code2", outcodeOf(s.b, w));
        if (step.test("beyond", (code1 & code2) != 0))
            return step.reject("rejectBeyond");
        bool contact = step.let("contact", "contact", false);
        Ways<T, N> ways{};
        if (step.test("outside", (code1 | code2) != 0))
            ways = waysOf(s, w, step);
        BasicSegment<T, N> visible = s;
        std::optional<Bracket<T>> last, first;
        if (step.test("end2", code2 != 0)) {
            if (!(last = seek("seek2", {T(0), code1, T(1), code2}, ways, step)))
                return std::nullopt;
            visible.b = place("place2", *last, s, w, ways, step);
            step.set("last", last->near), step.set("sides", last->codes());
            step.cut("move2", 1, visible.b, edgeOf(last->farCode));
            if (step.test("touches2", last->nearCode != 0)) {
                visible.a = visible.b, contact = step.set("contact", true);
                step.cut("contact2", 0, visible.a, edgeOf(last->nearCode));
            }
        }
        if (step.test("end1", code1 != 0 && !contact)) {
            if (!(first = seek("seek1", {T(1), code2, T(0), code1}, ways, step)))
                return std::nullopt;
            contact = step.let("touches1", "contact", first->nearCode != 0);
            const T least(1.0 / double(1ULL << steps<T>)); // distance of two neighbouring points
            if (step.test("onePoint", last && last->near - first->near <= least)) {
                contact = step.set("contact", true);
                first->nearCode = step.let("oneContact", "near", first->nearCode | last->codes());
                // In three dimensions both ends take the parameter found first, so that they are
                // one point.
                if constexpr (N > 2)
                    first->near = last->near;
            }
            visible.a = place("place1", *first, s, w, ways, step);
            step.cut("move1", 0, visible.a, edgeOf(first->farCode));
            if (step.test("isContact", contact)) {
                visible.b = visible.a;
                step.cut("contact1", 1, visible.b, edgeOf(first->nearCode));
            }
        }
        return step.accept("accept", visible);
    }
};

template Algorithm describe<MidpointSubdivision>();

} // namespace clipping
