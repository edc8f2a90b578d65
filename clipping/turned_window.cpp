// SPDX-License-Identifier: MIT
//
// The error bound K of turned windows, in ulps of M, with e = 2^-53, so that e M is at most one
// ulp. M is at least each |coordinate| of the ends and of the corners, hence of the centre. |c| +
// |s| is at most 1.415.
//
// 1. Turning an end p into the frame: (p - m) . u is two differences, two products and a sum, off
//    by 3e (|c| + |s|) 2M: 8.5 ulps. Both ends are moved by so much, and hence every point of the
//    segment.
// 2. The row is off by k ulps of the largest coordinate in the frame, at most 2.83 M: 4k ulps.
// 3. A new end q is inside the frame's window, so |c qx| + |s qy| is at most M. Turning it back
//    takes two products, two sums, and the factor 1 / (c^2 + s^2), 1 within 2e, is left out: 7e M.
//
// An error of E on each axis of the frame is one of at most 1.415 E on each axis of the drawing:
// 1.415 (4k + 8.5) + 7, less than 6k + 20. Underflow costs at most as many of the smallest numbers,
// which are ulps.

#include "clipping/turned_window.h"

#include "clipping/exact/line.h"
#include "clipping/frame.h"
#include "clipping/ieee_numbers.h"
#include "clipping/limits.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace clipping {
namespace {

/// Cosine and sine. For multiples of 90 degrees exactly 0 and 1.
glm::dvec2 directionOf(double degrees)
{
    const double rest = std::remainder(degrees, 90); // exact
    const auto quarters = static_cast<int>(std::lround((std::remainder(degrees, 360) - rest) / 90));
    const double radians = rest * 0.017453292519943295, c = std::cos(radians),
                 s = std::sin(radians);
    constexpr int round = 4;
    const std::array<glm::dvec2, round> all{{{c, s}, {-s, c}, {-c, -s}, {s, -c}}};
    return all[static_cast<std::size_t>((quarters % round + round) % round)];
}

double largest(const glm::dvec2& p) { return std::max(std::abs(p.x), std::abs(p.y)); }

/// Whether turning may overflow; then everything is divided by `muchSmaller` before.
bool isHuge(const Segment& s) { return !(std::max(largest(s.a), largest(s.b)) < 0x1p1000); }
constexpr double muchSmaller = 0x1p64;

/// Turns a segment into the frame of a window, and pieces back.
class Turning {
public:
    explicit Turning(const TurnedWindow& w, double unit = 1)
        : centre_(w.centre / unit), half_(w.half / unit), unit_(unit)
    {
        const auto direction = directionOf(w.degrees);
        c_ = direction.x, s_ = direction.y;
    }
    Window window() const { return {-half_, half_}; }

    glm::dvec2 into(const glm::dvec2& p) const
    {
        const double x = p.x / unit_ - centre_.x, y = p.y / unit_ - centre_.y;
        return {c_ * x + s_ * y, c_ * y - s_ * x};
    }
    Segment into(const Segment& s) const { return {into(s.a), into(s.b)}; }

    /// The piece in the drawing, where `s` is the segment and `turned` the same in the frame.
    Segment back(const Segment& piece, const Segment& s, const Segment& turned) const
    {
        const auto end = [&](const glm::dvec2& p) {
            return p == turned.a ? s.a : p == turned.b ? s.b : outOf(p);
        };
        return {end(piece.a), end(piece.b)};
    }

private:
    glm::dvec2 outOf(const glm::dvec2& q) const
    {
        return {unit_ * (centre_.x + (c_ * q.x - s_ * q.y)),
                unit_ * (centre_.y + (s_ * q.x + c_ * q.y))};
    }
    glm::dvec2 centre_, half_;
    double unit_, c_, s_;
};

bool isHuge(const TurnedWindow& w) { return isHuge(Segment{w.centre, w.half}); }

bool legal(const TurnedWindow& w)
{
    return legal(Window{-w.half, w.half}) && legal(Segment{w.centre, w.half})
           && std::isfinite(w.degrees);
}

/// The frame for one segment.
Turning turningFor(const Segment& s, const TurnedWindow& w)
{
    return Turning(w, isHuge(s) || isHuge(w) ? muchSmaller : 1);
}

} // namespace

TurnedWindow turned(const Window& window, double degrees)
{
    const auto half = window.max / 2.0 - window.min / 2.0;
    return {window.min / 2.0 + window.max / 2.0, half, degrees};
}

ConvexPolygon cornersOf(const TurnedWindow& w)
{
    const auto direction = directionOf(w.degrees);
    const double unit = isHuge(w) ? muchSmaller : 1, c = direction.x, s = direction.y;
    const auto centre = w.centre / unit;
    // m + c x + s y in one rounding, but for terms of second order.
    const auto sum = [unit](double m, double x, double p, double y, double q) {
        const auto xp = twoProduct(x, p), yq = twoProduct(y, q);
        const auto both = twoDifference(xp.high, -yq.high), all = twoDifference(m, -both.high);
        return unit * (all.high + (all.low + (both.low + (xp.low + yq.low))));
    };
    ConvexPolygon polygon;
    for (const auto& sign : {glm::dvec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
        const auto h = sign * w.half / unit;
        polygon.corners.emplace_back(sum(centre.x, c, h.x, -s, h.y), sum(centre.y, s, h.x, c, h.y));
    }
    return polygon;
}

std::optional<Segment> clipTurned(const Functions<Segment, Window>& form, const Segment& segment,
                                  const TurnedWindow& window)
{
    if (!legal(window))
        return std::nullopt;
    const Turning turning = turningFor(segment, window);
    const Segment inFrame = turning.into(segment);
    const auto piece = form.clip(inFrame, turning.window());
    return piece ? std::optional(turning.back(*piece, segment, inFrame)) : std::nullopt;
}

std::size_t clipAllTurned(ClipAllAtWindow clipAll, std::span<const Segment> in,
                          const TurnedWindow& window, std::span<Clipped> out)
{
    requireRoom(in.size(), out.size());
    if (!legal(window))
        return 0;
    constexpr std::size_t most = 256; // segments turned at a time: 8 KiB
    std::array<Segment, most> inFrame;
    std::size_t visible = 0;
    for (std::size_t first = 0, count = 0; first < in.size(); first += count) {
        count = std::min(most, in.size() - first);
        const auto part = in.subspan(first, count);
        const bool huge =
            isHuge(window) || std::ranges::any_of(part, [](const auto& s) { return isHuge(s); });
        if (huge)
            count = 1; // each in its own frame
        const Turning turning = huge ? turningFor(part[0], window) : Turning(window);
        for (std::size_t i = 0; i < count; ++i)
            inFrame[i] = turning.into(part[i]);
        const std::size_t pieces = clipAll({inFrame.data(), count}, turning.window(),
                                           out.subspan(visible, out.size() - visible));
        for (Clipped& piece : out.subspan(visible, pieces)) {
            const std::size_t i = piece.source;
            piece.segment = turning.back(piece.segment, part[i], inFrame[i]);
            piece.source = static_cast<std::uint32_t>(first + i);
        }
        visible += pieces;
    }
    return visible;
}

OperationCounts countTurned(const Functions<Segment, Window>& form, std::span<const Segment> in,
                            const TurnedWindow& window)
{
    OperationCounts all;
    for (const Segment& s : in) {
        if (!legal(window))
            continue;
        const Turning turning = turningFor(s, window);
        const Segment inFrame = turning.into(s);
        const auto one = form.count({&inFrame, 1}, turning.window());
        all.additions += one.additions, all.multiplications += one.multiplications;
        all.divisions += one.divisions, all.comparisons += one.comparisons;
        all.negations += one.negations;
    }
    return all;
}

Trace traceTurned(const Functions<Segment, Window>& form, const Segment& segment,
                  const TurnedWindow& window)
{
    if (!legal(window))
        return {};
    const Turning turning = turningFor(segment, window);
    return form.trace(turning.into(segment), turning.window());
}

} // namespace clipping
