// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/ulps.h"

#include "app/base/finite.h"
#include "app/base/numbers.h"

#include <glm/common.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace app {
namespace {

using clipping::Segment;

QString superscript(int number)
{
    static const QString digits = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
    QString text;
    for (const QChar digit : QString::number(number))
        text += digits[digit.digitValue()];
    return text;
}

constexpr double infinity = std::numeric_limits<double>::infinity();

double largest(const glm::dvec2& p) { return std::max(std::abs(p.x), std::abs(p.y)); }

double apart(const glm::dvec2& p, const glm::dvec2& q)
{
    const glm::dvec2 d = p - q;
    return isFinite(d) ? largest(d) : infinity;
}

} // namespace

double ulpFor(const Segment& line, const clipping::Window& window)
{
    const double most =
        std::max({largest(line.a), largest(line.b), largest(window.min), largest(window.max)});
    // This computes nextafter(most, infinity) - most in a tenth of the time.
    if (most >= std::numeric_limits<double>::min() * 0x1p53 && most <= 0x1p1023) {
        const auto exponent = std::bit_cast<std::uint64_t>(most) & 0x7FF0'0000'0000'0000;
        return std::bit_cast<double>(exponent - (std::uint64_t(52) << 52));
    }
    const double next = std::nextafter(most, infinity);
    return std::isfinite(next) ? next - most : most - std::nextafter(most, 0.0);
}

double endsApart(const Segment& one, const Segment& other, Ends ends)
{
    const double straight = std::max(apart(one.a, other.a), apart(one.b, other.b));
    if (ends == Ends::InOrder)
        return straight;
    return std::min(straight, std::max(apart(one.a, other.b), apart(one.b, other.a)));
}

double extentOf(const Segment& piece) { return apart(piece.a, piece.b); }

QString ulpsText(double ulps)
{
    if (!std::isfinite(ulps))
        return QStringLiteral("∞");
    if (ulps < 1e6)
        return numberText(ulps, ulps < 10 && ulps != std::floor(ulps) ? 1 : 0);
    const int exponent = int(std::floor(std::log10(ulps)));
    return QStringLiteral("%1 × 10%2")
        .arg(numberText(ulps / std::pow(10, exponent), 1), superscript(exponent));
}

} // namespace app
