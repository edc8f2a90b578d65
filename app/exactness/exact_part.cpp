// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exactness/exact_part.h"

#include "app/base/finite.h"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

// Boost is included only here: it takes seconds to compile.

namespace app {

using clipping::Segment;
using clipping::Window;
using glm::dvec2;

namespace {

/// 256 bits without heap allocation, which is enough for most drawings.
using Integer = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<256, 0, boost::multiprecision::signed_magnitude>,
    boost::multiprecision::et_off>;

constexpr int leastPlace = -1074, digits = 53;

/// The exponent of the last place of a finite number.
int lastPlace(double x) { return x == 0 ? 0 : std::max(std::ilogb(x) - (digits - 1), leastPlace); }

/// x / 2^unit, which is an integer.
Integer whole(double x, int unit)
{
    if (x == 0)
        return 0;
    const int place = lastPlace(x);
    return Integer(static_cast<long long>(std::ldexp(x, -place))) << unsigned(place - unit);
}

int bitsOf(const Integer& x) { return x == 0 ? 0 : int(msb(abs(x))) + 1; }

/// over / under * 2^unit, rounded to nearest, to even in a tie. under > 0.
double rounded(const Integer& over, const Integer& under, int unit)
{
    if (over == 0)
        return 0;
    // A quotient with two bits more than a double; its last bit is also set for a remainder.
    int shift = digits + 2 - (bitsOf(over) - bitsOf(under));
    shift = std::min(shift, unit - leastPlace + 2); // not below the smallest doubles
    Integer n = abs(over), d = under;
    if (shift >= 0)
        n <<= unsigned(shift);
    else
        d <<= unsigned(-shift);
    Integer quotient, remainder;
    divide_qr(n, d, quotient, remainder);
    auto q = static_cast<unsigned long long>(quotient);
    int place = unit - shift;
    // Rounds to 53 digits here, and to integer multiples of the smallest double: ldexp would round
    // again.
    int spare = 0;
    while ((q >> spare) >> digits != 0)
        ++spare;
    spare = std::max(spare, leastPlace - place);
    if (spare > 0) {
        const unsigned long long half = 1ULL << (spare - 1), low = q & (2 * half - 1);
        q >>= spare;
        const bool more = low > half || (low == half && remainder != 0);
        if (more || (low == half && q % 2 == 1))
            ++q;
        place += spare;
    }
    const double magnitude = std::ldexp(double(q), place);
    return over < 0 ? -magnitude : magnitude;
}

/// A parameter of the line; under > 0.
struct Ratio {
    Integer over, under;
};
bool less(const Ratio& s, const Ratio& t) { return s.over * t.under < t.over * s.under; }

/// A line and a window in units of 2^unit.
struct Whole {
    int unit = 0;
    std::array<Integer, 2> a, d, min, max;

    Whole(const Segment& line, const Window& window)
    {
        bool first = true;
        for (const dvec2& p : {line.a, line.b, window.min, window.max})
            for (const double x : {p.x, p.y})
                if (x != 0) {
                    unit = first ? lastPlace(x) : std::min(unit, lastPlace(x));
                    first = false;
                }
        for (const int k : {0, 1}) {
            a[k] = whole(line.a[k], unit);
            d[k] = whole(line.b[k], unit) - a[k];
            min[k] = whole(window.min[k], unit);
            max[k] = whole(window.max[k], unit);
        }
    }

    /// The parameters where the line enters and leaves the window; empty if it is not inside.
    std::optional<std::array<Ratio, 2>> interval() const
    {
        std::array<Ratio, 2> found{Ratio{0, 1}, Ratio{1, 1}};
        for (const int k : {0, 1}) {
            if (d[k] == 0) {
                if (a[k] < min[k] || a[k] > max[k])
                    return std::nullopt;
                continue;
            }
            const bool up = d[k] > 0;
            const Ratio enter{up ? min[k] - a[k] : a[k] - max[k], abs(d[k])};
            const Ratio leave{up ? max[k] - a[k] : a[k] - min[k], abs(d[k])};
            if (less(found[0], enter))
                found[0] = enter;
            if (less(leave, found[1]))
                found[1] = leave;
        }
        if (less(found[1], found[0]))
            return std::nullopt;
        return found;
    }

    ExactEnd at(const Ratio& t) const
    {
        ExactEnd end{.isNew = true};
        for (const int k : {0, 1}) {
            const Integer over = a[k] * t.under + d[k] * t.over;
            end.nearest[k] = rounded(over, t.under, unit);
            const int place = std::min(unit, lastPlace(end.nearest[k]));
            const Integer rest =
                (over << unsigned(unit - place)) - whole(end.nearest[k], place) * t.under;
            end.rest[k] = rounded(rest, t.under, place);
        }
        return end;
    }
};

bool isInside(const dvec2& p, const Window& w)
{
    return p.x >= w.min.x && p.x <= w.max.x && p.y >= w.min.y && p.y <= w.max.y;
}

bool isBeyondASide(const Segment& s, const Window& w)
{
    for (const int k : {0, 1})
        if (std::max(s.a[k], s.b[k]) < w.min[k] || std::min(s.a[k], s.b[k]) > w.max[k])
            return true;
    return false;
}

} // namespace

std::optional<ExactPart> exactPart(const Segment& line, const Window& window)
{
    const bool legal = isFinite(line.a) && isFinite(line.b) && isFinite(window.min)
                       && isFinite(window.max) && window.min.x <= window.max.x
                       && window.min.y <= window.max.y;
    if (!legal || isBeyondASide(line, window))
        return std::nullopt;
    const bool aInside = isInside(line.a, window), bInside = isInside(line.b, window);
    if (aInside && bInside)
        return ExactPart{{line.a}, {line.b}};
    const Whole all(line, window);
    const auto interval = all.interval();
    if (!interval)
        return std::nullopt;
    const auto& [enter, leave] = *interval;
    return ExactPart{aInside ? ExactEnd{line.a} : all.at(enter),
                     bInside ? ExactEnd{line.b} : all.at(leave)};
}

double distanceLeftOf(const Segment& line, const dvec2& point)
{
    const Whole all(line, {point, point});
    const Integer cross = all.d[0] * (all.min[1] - all.a[1]) - all.d[1] * (all.min[0] - all.a[0]);
    // 64 bits suffice for the length; the position relative to the line is exact.
    const dvec2 d = line.b / 2.0 - line.a / 2.0;
    const double length = std::hypot(d.x, d.y);
    int exponent = 0;
    const double fraction = std::frexp(length, &exponent);
    return rounded(cross, Integer(1), 2 * all.unit - exponent - 1) / fraction;
}

} // namespace app
