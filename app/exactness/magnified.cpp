// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exactness/magnified.h"

#include "app/base/finite.h"
#include "app/comparison/ulps.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace app {

using clipping::Segment;
using clipping::Window;
using glm::dvec2;

namespace {

double largest(const dvec2& p) { return std::max(std::abs(p.x), std::abs(p.y)); }

/// The true end that corresponds to an end of a piece.
const ExactEnd& exactEnd(const ExactPart& part, const Segment& piece, int end,
                         const Variant& variant)
{
    const auto worse = [&](const ExactEnd& a, const ExactEnd& b) {
        return std::max(largest(a.offOf(piece.a)), largest(b.offOf(piece.b)));
    };
    const bool turned =
        variant.form == clipping::Form::Published && worse(part.b, part.a) < worse(part.a, part.b);
    return (end == 0) != turned ? part.a : part.b;
}

dvec2 unit(const Segment& line)
{
    const dvec2 half = line.b / 2.0 - line.a / 2.0; // halves, because the difference may overflow
    const double size = largest(half);
    if (size == 0)
        return {};
    const dvec2 scaled = half / size;
    return scaled / std::hypot(scaled.x, scaled.y);
}

double spacingAt(double x)
{
    return std::nextafter(std::abs(x), std::numeric_limits<double>::infinity()) - std::abs(x);
}

template <class Number>
std::vector<double> walked(double centre, double from, double to, std::size_t most)
{
    constexpr Number far = std::numeric_limits<Number>::infinity();
    const auto start = Number(centre);
    const auto offset = [&](Number x) { return double(x) - centre; };
    std::vector<double> found;
    Number x = start;
    while (std::isfinite(x) && offset(x) >= from && found.size() <= most) {
        found.push_back(offset(x));
        x = std::nextafter(x, -far);
    }
    x = std::nextafter(start, far);
    while (std::isfinite(x) && offset(x) <= to && found.size() <= most) {
        found.push_back(offset(x));
        x = std::nextafter(x, far);
    }
    if (found.size() > most)
        return {};
    std::ranges::sort(found);
    std::erase_if(found, [&](double at) { return at < from || at > to; });
    return found;
}

} // namespace

std::optional<Magnified> magnified(const Variant& variant, const Segment& line,
                                   const Window& window, int end)
{
    const auto piece = clipped(variant, line, window);
    const auto part = exactPart(line, window);
    if ((!piece && !part) || (piece && !(isFinite(piece->a) && isFinite(piece->b))))
        return std::nullopt;
    Magnified seen{};
    const ExactEnd* exactness = nullptr;
    if (part)
        exactness = piece ? &exactEnd(*part, *piece, end, variant) : end == 0 ? &part->a : &part->b;
    seen.returned = piece.has_value();
    seen.centre = piece ? (end == 0 ? piece->a : piece->b) : exactness->nearest;
    if (exactness) {
        seen.exactness = -exactness->offOf(seen.centre);
        seen.nearest = exactness->nearest - seen.centre;
    }
    seen.direction = unit(line);
    if (seen.direction != dvec2{})
        seen.onLine =
            dvec2(seen.direction.y, -seen.direction.x) * distanceLeftOf(line, seen.centre);
    seen.window = {window.min - seen.centre, window.max - seen.centre};
    seen.ulp = {spacingAt(seen.centre.x), spacingAt(seen.centre.y)};
    seen.largestUlp = ulpFor(line, window);
    return seen;
}

std::vector<double> latticeBetween(double centre, double from, double to, Lattice lattice,
                                   std::size_t most)
{
    return lattice == Lattice::Double ? walked<double>(centre, from, to, most)
                                      : walked<float>(centre, from, to, most);
}

} // namespace app
