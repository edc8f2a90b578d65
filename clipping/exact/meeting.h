// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/exact/line.h"
#include "clipping/geometry.h"

#include <optional>

// The point where two lines meet, exact for all finite numbers and rounded once on each axis:
// computed in floating point where bounds.h proves this sufficient, in integers elsewhere. N is
// double, or Counted<double> to count operations.

namespace clipping {

/// `meeting`, computed in integers alone.
glm::dvec2 meetingInIntegers(const Segment& s, const Segment& edge);

/// A determinant of two vectors, high + low; and the sum of the magnitudes of its two products.
template <class N>
struct Determinant {
    N high, low, size;
};
template <class N>
// NOLINTNEXTLINE(readability-function-size): two vectors of two pairs
Determinant<N> determinant(NumberPair<N> ux, NumberPair<N> uy, NumberPair<N> vx, NumberPair<N> vy)
{
    const auto p = twoProduct(ux.high, vy.high), q = twoProduct(uy.high, vx.high);
    const N lowP = p.low + ux.high * vy.low + ux.low * vy.high;
    const N lowQ = q.low + uy.high * vx.low + uy.low * vx.high;
    const auto difference = twoDifference(p.high, q.high);
    return {difference.high, difference.low + (lowP - lowQ), magnitude(p.high) + magnitude(q.high)};
}

/// How far along a line a point is, 0 to 1, as a number and its rest; and the two quotients that
/// bound its error (bounds.h).
template <class N>
struct MeetingShare {
    N high, low;
    N spread, skew; ///< PN / |D| and PD / |D|
    bool tame;      ///< whether the bounds hold
};
template <class N>
MeetingShare<N> shareOf(const Determinant<N>& n, const Determinant<N>& d)
{
    const auto tame = [](const Determinant<N>& x) {
        return plain(x.size) >= smallestMeeting && plain(x.size) <= largestMeeting;
    };
    const N high = d.high + d.low, low = d.low - (high - d.high), inverse = N(1) / high;
    const N share = n.high * inverse;
    const auto back = twoProduct(share, high);
    const N rest = ((n.high - back.high) - back.low) + (n.low - share * low);
    const N size = magnitude(inverse);
    return {share, rest * inverse, n.size * size, d.size * size,
            tame(n) && tame(d) && magnitude(high) > N(meetingBound) * d.size};
}

/// A coordinate of the point at a share of the way from `start`; nothing where the bounds leave two
/// numbers.
template <class N>
std::optional<N> coordinateAt(const MeetingShare<N>& t, N start, NumberPair<N> way)
{
    const auto p = twoProduct(way.high, t.high);
    const N low = p.low + way.high * t.low + way.low * t.high;
    const auto s = twoDifference(start, -p.high);
    const N rest = s.low + low;
    const N error =
        N(quotientBound)
        * (magnitude(way.high) * t.spread + magnitude(p.high) * t.skew + magnitude(s.high));
    const double below = plain(s.high + (rest - error)), above = plain(s.high + (rest + error));
    if (t.tame && plain(error) >= smallestMeetingBound && below == above)
        return N(below + 0.0); // never -0
    return std::nullopt;
}

/// The point where the lines of two segments meet, each coordinate rounded once to the nearest
/// number, ties to even; never -0. The lines must not be parallel, and the point within the bounding
/// box of s; `edge` only defines a line. It is the same, bit for bit, for segments that are reversed
/// or, if it is within both boxes, exchanged.
template <class N>
glm::vec<2, N> meeting(const BasicSegment<N>& s, const BasicSegment<N>& edge)
{
    const auto &a = s.a, &b = s.b, &c = edge.a, &d = edge.b;
    const auto wayX = twoDifference(b.x, a.x), wayY = twoDifference(b.y, a.y);
    const auto edgeX = twoDifference(d.x, c.x), edgeY = twoDifference(d.y, c.y);
    const auto offX = twoDifference(c.x, a.x), offY = twoDifference(c.y, a.y);
    const auto share =
        shareOf(determinant(offX, offY, edgeX, edgeY), determinant(wayX, wayY, edgeX, edgeY));
    const auto x = b.x == a.x   ? std::optional(a.x + N(0))
                   : d.x == c.x ? std::optional(c.x + N(0))
                                : coordinateAt(share, a.x, wayX);
    const auto y = b.y == a.y   ? std::optional(a.y + N(0))
                   : d.y == c.y ? std::optional(c.y + N(0))
                                : coordinateAt(share, a.y, wayY);
    if (x && y)
        return {*x, *y};
    const auto exact = meetingInIntegers({{plain(a.x), plain(a.y)}, {plain(b.x), plain(b.y)}},
                                         {{plain(c.x), plain(c.y)}, {plain(d.x), plain(d.y)}});
    return {N(exact.x), N(exact.y)};
}

} // namespace clipping
