// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/clipping/oracle.h"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

namespace oracle {
namespace {

using Int = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<256, 0, boost::multiprecision::signed_magnitude>,
    boost::multiprecision::et_off>;

constexpr int leastExponent = -1074; // of a double's last place

/// The exponent of x's last place.
int lastPlace(double x)
{
    return x == 0 ? leastExponent : std::max(std::ilogb(x) - 52, leastExponent);
}

/// A parameter of the line: numerator over a positive denominator.
struct Ratio {
    Int over, under;
    friend bool operator<(const Ratio& s, const Ratio& t)
    {
        return s.over * t.under < t.over * s.under;
    }
};

/// The eight numbers in units of 2^exponent.
struct Whole {
    int exponent;
    Int a[2], d[2], low[2], high[2];

    Whole(const Line& l, const Box& b, int ulps)
    {
        const std::array all{l.a.x, l.a.y, l.b.x, l.b.y, b.min.x, b.min.y, b.max.x, b.max.y};
        const int unit = std::ilogb(ulp(l, b));
        exponent = unit;
        for (const double x : all)
            if (x != 0)
                exponent = std::min(exponent, lastPlace(x));
        a[0] = whole(l.a.x), a[1] = whole(l.a.y);
        d[0] = whole(l.b.x) - a[0], d[1] = whole(l.b.y) - a[1];
        const Int margin = (Int(std::abs(ulps)) << unsigned(unit - exponent)) * (ulps < 0 ? -1 : 1);
        low[0] = whole(b.min.x) - margin, low[1] = whole(b.min.y) - margin;
        high[0] = whole(b.max.x) + margin, high[1] = whole(b.max.y) + margin;
    }

    Int whole(double x) const
    {
        if (x == 0)
            return 0;
        const int place = lastPlace(x);
        return Int(static_cast<long long>(std::ldexp(x, -place))) << unsigned(place - exponent);
    }

    struct Interval {
        Ratio from, to;
    };
    /// The line's parameters inside the box.
    std::optional<Interval> interval() const
    {
        Interval found{{0, 1}, {1, 1}};
        for (int k = 0; k < 2; ++k) {
            if (low[k] > high[k])
                return std::nullopt;
            if (d[k] == 0) {
                if (a[k] < low[k] || a[k] > high[k])
                    return std::nullopt;
                continue;
            }
            const bool up = d[k] > 0;
            const Int under = up ? d[k] : Int(-d[k]);
            const Ratio in{up ? Int(low[k] - a[k]) : Int(a[k] - high[k]), under};
            const Ratio out{up ? Int(high[k] - a[k]) : Int(a[k] - low[k]), under};
            found = {std::max(found.from, in), std::min(found.to, out)};
        }
        if (found.to < found.from)
            return std::nullopt;
        return found;
    }

    /// A coordinate of the point at t, rounded.
    double at(const Ratio& t, int k) const
    {
        Int over = a[k] * t.under + d[k] * t.over;
        if (over == 0)
            return 0;
        const bool negative = over < 0;
        if (negative)
            over = -over;
        // 64 bits of the quotient, the last of them sticky, so that one rounding is left.
        const int shift = 64 + int(msb(t.under)) - int(msb(over));
        Int quotient, rest;
        if (shift > 0)
            divide_qr(Int(over << unsigned(shift)), t.under, quotient, rest);
        else
            divide_qr(over, Int(t.under << unsigned(-shift)), quotient, rest);
        const bool sticky = (quotient & 1) != 0 || rest != 0;
        quotient >>= 1;
        if (sticky)
            quotient |= 1;
        const auto bits = static_cast<long double>(static_cast<unsigned long long>(quotient));
        return static_cast<double>(std::ldexp(negative ? -bits : bits, exponent + 1 - shift));
    }
    Point at(const Ratio& t) const { return {at(t, 0), at(t, 1)}; }
};

} // namespace

double ulp(const Line& l, const Box& b)
{
    const double largest =
        std::max({std::abs(l.a.x), std::abs(l.a.y), std::abs(l.b.x), std::abs(l.b.y),
                  std::abs(b.min.x), std::abs(b.min.y), std::abs(b.max.x), std::abs(b.max.y)});
    return std::ldexp(1.0, lastPlace(largest));
}

std::optional<Part> inside(const Line& l, const Box& b)
{
    if ((l.a.x < b.min.x && l.b.x < b.min.x) || (l.a.x > b.max.x && l.b.x > b.max.x)
        || (l.a.y < b.min.y && l.b.y < b.min.y) || (l.a.y > b.max.y && l.b.y > b.max.y))
        return std::nullopt;
    const Whole whole(l, b, 0);
    const auto found = whole.interval();
    if (!found)
        return std::nullopt;
    const bool newA = found->from.over != 0, newB = found->to.over != found->to.under;
    return Part{{newA ? whole.at(found->from) : l.a, newB ? whole.at(found->to) : l.b}, newA, newB};
}

bool meets(const Line& l, const Box& b, int ulps)
{
    return Whole(l, b, ulps).interval().has_value();
}

} // namespace oracle
