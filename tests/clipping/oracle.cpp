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
int lastPlace(double x, Number number = Number::Double)
{
    const bool single = number == Number::Single;
    const int least = single ? -149 : leastExponent;
    return x == 0 ? least : std::max(std::ilogb(x) - (single ? 23 : 52), least);
}

/// A parameter of the line: numerator over a positive denominator.
struct Ratio {
    Int over, under;
    friend bool operator<(const Ratio& s, const Ratio& t)
    {
        return s.over * t.under < t.over * s.under;
    }
};

template <int n>
using Coordinates = std::array<double, n>;

Coordinates<2> coordinates(const Point& p) { return {p.x, p.y}; }
Coordinates<3> coordinates(const Point3& p) { return {p.x, p.y, p.z}; }
Point point(const Coordinates<2>& c) { return {c[0], c[1]}; }
Point3 point(const Coordinates<3>& c) { return {c[0], c[1], c[2]}; }

/// A line and a box.
template <int n>
struct ExactInput {
    Coordinates<n> a, b, min, max;

    double ulp(Number number) const
    {
        double largest = 0;
        for (const auto* p : {&a, &b, &min, &max})
            for (const double x : *p)
                largest = std::max(largest, std::abs(x));
        return std::ldexp(1.0, lastPlace(largest, number));
    }
    bool isBeyondASide() const
    {
        for (int k = 0; k < n; ++k)
            if ((a[k] < min[k] && b[k] < min[k]) || (a[k] > max[k] && b[k] > max[k]))
                return true;
        return false;
    }
};
ExactInput<2> exactInput(const Line& l, const Box& b)
{
    return {coordinates(l.a), coordinates(l.b), coordinates(b.min), coordinates(b.max)};
}
ExactInput<3> exactInput(const Line3& l, const Box3& b)
{
    return {coordinates(l.a), coordinates(l.b), coordinates(b.min), coordinates(b.max)};
}

/// Its numbers in units of 2^exponent.
template <int n>
struct Whole {
    int exponent;
    Int a[n], d[n], low[n], high[n];

    Whole(const ExactInput<n>& all, int ulps, Number number)
    {
        const int unit = std::ilogb(all.ulp(number));
        exponent = unit;
        for (const auto* p : {&all.a, &all.b, &all.min, &all.max})
            for (const double x : *p)
                if (x != 0)
                    exponent = std::min(exponent, lastPlace(x));
        const Int margin = (Int(std::abs(ulps)) << unsigned(unit - exponent)) * (ulps < 0 ? -1 : 1);
        for (int k = 0; k < n; ++k) {
            a[k] = whole(all.a[k]);
            d[k] = whole(all.b[k]) - a[k];
            low[k] = whole(all.min[k]) - margin;
            high[k] = whole(all.max[k]) + margin;
        }
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
        for (int k = 0; k < n; ++k) {
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
    Coordinates<n> at(const Ratio& t) const
    {
        Coordinates<n> point;
        for (int k = 0; k < n; ++k)
            point[k] = at(t, k);
        return point;
    }
};

template <class P>
std::optional<BasicPart<P>> insideOf(const BasicLine<P>& l, const BasicBox<P>& box)
{
    const auto all = exactInput(l, box);
    if (all.isBeyondASide())
        return std::nullopt;
    const Whole whole(all, 0, Number::Double);
    const auto found = whole.interval();
    if (!found)
        return std::nullopt;
    const bool newA = found->from.over != 0, newB = found->to.over != found->to.under;
    return BasicPart<P>{
        {newA ? point(whole.at(found->from)) : l.a, newB ? point(whole.at(found->to)) : l.b},
        newA,
        newB,
        !(found->from < found->to) || all.a == all.b};
}

} // namespace

double ulp(const Line& l, const Box& b, Number number) { return exactInput(l, b).ulp(number); }
double ulp(const Line3& l, const Box3& b, Number number) { return exactInput(l, b).ulp(number); }

std::optional<Part> inside(const Line& l, const Box& b) { return insideOf(l, b); }
std::optional<Part3> inside(const Line3& l, const Box3& b) { return insideOf(l, b); }

bool meets(const Line& l, const Box& b, int ulps, Number number)
{
    return Whole(exactInput(l, b), ulps, number).interval().has_value();
}
bool meets(const Line3& l, const Box3& b, int ulps, Number number)
{
    return Whole(exactInput(l, b), ulps, number).interval().has_value();
}

} // namespace oracle
