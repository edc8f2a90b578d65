// SPDX-License-Identifier: MIT
#include "clipping/exact/meeting_point.h"

#include "clipping/exact/line.h"
#include "clipping/exact/quotient.h"
#include "clipping/ieee_numbers.h"

#include <optional>

// The point is a + d N / D with d = b - a, e = v - u (the edge), N = (u - a) x e and D = d x e. All
// is computed in pairs of doubles. e below also stands for 2^-53, the relative error of a rounding;
// a difference of doubles is an exact pair whose low part is at most e times the high one.
//
// A cross product with terms P and Q, B = |P| + |Q|: the highs are multiplied exactly. Leaving out
// low times low costs e^2 B; rounding the products of high and low and their sums 4 e^2 B; adding
// the low parts up 10 e^2 B. Together less than 16 e^2 B; `crossBound` is 32.
//
// T = N / D as a quotient and the quotient of its rest: 18 e^2 |T| by rounding (10 in the rest, 8
// in its quotient); N and D contribute 32 e^2 (B_N + |T| B_D) / |D|, times 16/15 because D is known
// within a sixteenth. d T adds 20 e^2 |d T|, the sum with a e (|sum| + 6 e |d T|), of which the
// high part is exact. Together less than 45 e^2 |d T| + e^2 |sum| + 35 e^2 |d| (B_N + |T| B_D) /
// |D|: `pointBound`, 128 e^2, covers each and the rounding of the bound. Where rounding sum - bound
// and sum + bound gives the same double, it is the nearest one of the exact value.
//
// Nothing of this underflows or overflows where coordinates are at most 2^100 and differences 0 or
// at least 2^-100: products are at least 2^-200, and D, at least 2^-97 B_D, 2^-297. What the
// quotients lose by underflow, 2^-1070 / 2^-297 * 2^100, is below `lost`. Other numbers, and what
// the bound leaves open, are decided in integers.

namespace clipping {
namespace {

using Pair = NumberPair<double>;

constexpr double crossBound = 0x1p-101, pointBound = 0x1p-99, lost = 0x1p-600;

Pair sum(double a, double b) { return twoDifference(a, -b); }

struct PairPoint {
    Pair x, y;
};
PairPoint difference(const glm::dvec2& to, const glm::dvec2& from)
{
    return {twoDifference(to.x, from.x), twoDifference(to.y, from.y)};
}

struct PairCross {
    Pair value;
    double size; ///< the sum of the magnitudes of its terms
};
PairCross cross(const PairPoint& p, const PairPoint& q)
{
    const Pair left = twoProduct(p.x.high, q.y.high), right = twoProduct(p.y.high, q.x.high);
    const double ofLeft = p.x.high * q.y.low + p.x.low * q.y.high;
    const double ofRight = p.y.high * q.x.low + p.y.low * q.x.high;
    const Pair highs = twoDifference(left.high, right.high);
    const double low = ((left.low - right.low) + (ofLeft - ofRight)) + highs.low;
    return {sum(highs.high, low), magnitude(left.high) + magnitude(right.high)};
}

/// The share of the way at which the segment crosses the edge, within `error`.
struct PairShare {
    Pair value;
    double error;
};
std::optional<PairShare> shareOf(const PairCross& over, const PairCross& under)
{
    const double size = magnitude(under.value.high);
    if (!(size >= 16 * crossBound * under.size))
        return std::nullopt;
    const double quotient = over.value.high / under.value.high;
    const Pair back = twoProduct(quotient, under.value.high);
    const double rest =
        (((over.value.high - back.high) - back.low) + over.value.low) - quotient * under.value.low;
    const double error = (over.size + magnitude(quotient) * under.size) / size;
    return PairShare{{quotient, rest / under.value.high}, pointBound * error};
}

/// from + along * share, rounded to the nearest double, where the bound proves it.
std::optional<double> nearestAt(double from, const Pair& along, const PairShare& share)
{
    const Pair way = twoProduct(along.high, share.value.high);
    const double wayLow = way.low + (along.high * share.value.low + along.low * share.value.high);
    const Pair whole = sum(from, way.high);
    const double low = whole.low + wayLow;
    const double error = pointBound * (magnitude(way.high) + magnitude(whole.high))
                         + share.error * magnitude(along.high) + lost;
    const double below = whole.high + (low - error), above = whole.high + (low + error);
    return below == above ? std::optional(below + 0.0) : std::nullopt; // never -0
}

bool tame(double x) { return magnitude(x) <= 0x1p100; }
bool tame(const glm::dvec2& p) { return tame(p.x) && tame(p.y); }
bool tame(const Pair& difference)
{
    return difference.high == 0 || magnitude(difference.high) >= 0x1p-100;
}
bool tame(const PairPoint& p) { return tame(p.x) && tame(p.y); }

std::optional<glm::dvec2> meetingInPairs(const Segment& s, const Segment& edge)
{
    const PairPoint along = difference(s.b, s.a), edgeAlong = difference(edge.b, edge.a);
    const PairPoint to = difference(edge.a, s.a);
    if (!(tame(s.a) && tame(s.b) && tame(edge.a) && tame(edge.b) && tame(along) && tame(edgeAlong)
          && tame(to)))
        return std::nullopt;
    const auto share = shareOf(cross(to, edgeAlong), cross(along, edgeAlong));
    if (!share)
        return std::nullopt;
    const auto x = nearestAt(s.a.x, along.x, *share), y = nearestAt(s.a.y, along.y, *share);
    return x && y ? std::optional(glm::dvec2(*x, *y)) : std::nullopt;
}

glm::dvec2 meetingInIntegers(const Segment& s, const Segment& edge)
{
    const int unit =
        commonExponent({s.a.x, s.a.y, s.b.x, s.b.y, edge.a.x, edge.a.y, edge.b.x, edge.b.y});
    const auto whole = [unit](double value) { return ExactInteger(value, unit); };
    const auto dx = whole(s.b.x) - whole(s.a.x), dy = whole(s.b.y) - whole(s.a.y);
    const auto ex = whole(edge.b.x) - whole(edge.a.x), ey = whole(edge.b.y) - whole(edge.a.y);
    const auto over = (whole(edge.a.x) - whole(s.a.x)) * ey - (whole(edge.a.y) - whole(s.a.y)) * ex;
    const auto under = dx * ey - dy * ex;
    return {nearest<double>(whole(s.a.x) * under + dx * over, under, unit),
            nearest<double>(whole(s.a.y) * under + dy * over, under, unit)};
}

/// The other coordinate at which a line passes x, for a line that may be horizontal.
double yAt(double x, const glm::dvec2& a, const glm::dvec2& b)
{
    return a.y == b.y ? a.y : crossing<double>(a.x, a.y, b.x, b.y, x);
}
double xAt(double y, const glm::dvec2& a, const glm::dvec2& b)
{
    return a.x == b.x ? a.x : crossing<double>(a.y, a.x, b.y, b.x, y);
}

} // namespace

glm::dvec2 meetingPoint(const Segment& s, const Segment& edge)
{
    const auto positive = [](double x, double y) { return glm::dvec2(x + 0.0, y + 0.0); };
    if (edge.a.x == edge.b.x)
        return positive(edge.a.x, yAt(edge.a.x, s.a, s.b));
    if (edge.a.y == edge.b.y)
        return positive(xAt(edge.a.y, s.a, s.b), edge.a.y);
    if (s.a.x == s.b.x)
        return positive(s.a.x, yAt(s.a.x, edge.a, edge.b));
    if (s.a.y == s.b.y)
        return positive(xAt(s.a.y, edge.a, edge.b), s.a.y);
    const auto point = meetingInPairs(s, edge);
    return point ? *point : meetingInIntegers(s, edge);
}

} // namespace clipping
