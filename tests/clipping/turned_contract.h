// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The contract of clipping/turned_window.h, checked with rational numbers: the window is the exact
// rectangle of its definition, with the cosine and sine that the library uses.

#include "clipping/turned_window.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "tests/clipping/rational.h"
#include "tests/clipping/same_bits.h"

namespace turned_contract {

using namespace clipping;

struct Fractions {
    Rational x, y;
};

/// The exact window: the direction is read from the corners of a window around the origin.
class Frame {
public:
    explicit Frame(const TurnedWindow& w)
        : cx_(rational(w.centre.x)),
          cy_(rational(w.centre.y)), half_{rational(w.half.x), rational(w.half.y)}
    {
        const auto axis = cornersOf({{0, 0}, {1, 0}, w.degrees}).corners[1];
        c_ = rational(axis.x), s_ = rational(axis.y);
    }
    Fractions into(const glm::dvec2& p) const
    {
        const Rational x = rational(p.x) - cx_, y = rational(p.y) - cy_;
        return {c_ * x + s_ * y, c_ * y - s_ * x};
    }
    bool has(const Fractions& p, const Rational& more) const
    {
        return abs(p.x) <= half_.x + more && abs(p.y) <= half_.y + more;
    }
    /// The parameters of the part of a segment inside the window, moved out by `more`.
    std::optional<std::pair<Rational, Rational>> part(const Segment& s, const Rational& more) const
    {
        const Fractions a = into(s.a), b = into(s.b);
        Rational from(0), to(1);
        const auto within = [&](const Rational& start, const Rational& end, const Rational& half) {
            const Rational zero(0), way = end - start;
            if (half < zero || (way == zero && abs(start) > half))
                return false;
            if (way == zero)
                return true;
            const Rational t = (-half - start) / way, u = (half - start) / way;
            from = std::max(from, std::min(t, u)), to = std::min(to, std::max(t, u));
            return from <= to;
        };
        if (!within(a.x, b.x, half_.x + more) || !within(a.y, b.y, half_.y + more))
            return std::nullopt;
        return std::pair(from, to);
    }

private:
    Rational cx_, cy_, c_, s_;
    Fractions half_;
};

inline double ulpOf(const Segment& s, const TurnedWindow& w)
{
    double most = 0;
    for (const auto& p : cornersOf(w).corners)
        most = std::max({most, std::abs(p.x), std::abs(p.y)});
    for (const auto& p : {s.a, s.b})
        most = std::max({most, std::abs(p.x), std::abs(p.y)});
    return std::max(most == 0 ? 0 : std::ldexp(1.0, std::ilogb(most) - 52), 0x1p-1074);
}

/// What is wrong with a result; empty if nothing is.
inline std::string turnedFault(const Algorithm& row, const Segment& s, const TurnedWindow& w)
{
    const auto found = clipTurned(row.corrected, s, w);
    const Frame frame(w);
    const Rational more = rational(ulpOf(s, w)) * Rational(int(turnedUlps(row)));
    const auto least = frame.part(s, -more), most = frame.part(s, more);
    if (!found)
        return least ? "lost" : "";
    if (!most)
        return "seen where there is nothing";
    const Rational ax = rational(s.a.x), ay = rational(s.a.y);
    const Rational dx = rational(s.b.x) - ax, dy = rational(s.b.y) - ay, all = abs(dx) + abs(dy);
    for (const auto& p : {found->a, found->b}) {
        const Rational x = rational(p.x) - ax, y = rational(p.y) - ay, along = x * dx + y * dy;
        if (p != s.a && p != s.b && !frame.has(frame.into(p), more))
            return "outside the window";
        if (abs(dx * y - dy * x) > more * all || along < -more * all
            || along > dx * dx + dy * dy + more * all)
            return "off the segment";
    }
    const Rational zero(0), one(1);
    const auto way = [&](const glm::dvec2& p) {
        return (rational(p.x) - ax) * dx + (rational(p.y) - ay) * dy;
    };
    const Rational length = dx * dx + dy * dy;
    if (least
        && (way(found->a) > least->first * length + more * all
            || way(found->b) < least->second * length - more * all))
        return "a part is missing";
    if (least
        && ((least->first == zero && !sameBits(found->a, s.a))
            || (least->second == one && !sameBits(found->b, s.b))))
        return "an inner end has moved";
    return {};
}

inline std::string described(const Segment& s, const TurnedWindow& w)
{
    char text[300];
    std::snprintf(text, sizeof text, "%a, %a, %a, %a at %a, %a, %a, %a, %a degrees", s.a.x, s.a.y,
                  s.b.x, s.b.y, w.centre.x, w.centre.y, w.half.x, w.half.y, w.degrees);
    return text;
}

} // namespace turned_contract
