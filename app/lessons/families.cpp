// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/families.h"

#include "app/comparison/variants.h"
#include "clipping/outcode.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace app {

namespace {

using clipping::Segment, clipping::Window;

int wholeBetween(Random& random, int low, int high)
{
    return int(std::floor(random.between(low, high + 1)));
}

Point middleOf(const Window& w) { return w.min / 2.0 + w.max / 2.0; }
Point halfOf(const Window& w) { return w.max / 2.0 - w.min / 2.0; }

/// A step between numbers that are easy to read: a tenth of the window's larger half, as 1, 2 or 5
/// times a power of ten.
double readableStep(const Window& window)
{
    const Point half = halfOf(window);
    const double most = std::max(half.x, half.y) / 10,
                 ten = std::pow(10, std::floor(std::log10(most)));
    return most >= 5 * ten ? 5 * ten : most >= 2 * ten ? 2 * ten : ten;
}

/// Ends of few digits, in and around the window.
Segment anywhere(Random& random, const Window& window)
{
    const double step = readableStep(window);
    const auto number = [&](double middle, double half) {
        const int steps = int(1.8 * half / step);
        return (std::round(middle / step) + wholeBetween(random, -steps, steps)) * step;
    };
    const auto end = [&] {
        const double x = number(middleOf(window).x, halfOf(window).x);
        return Point{x, number(middleOf(window).y, halfOf(window).y)};
    };
    const Point a = end();
    return {a, end()};
}

/// What becomes of a line.
enum class Fate : std::uint8_t { Inside, OneEnd, BothEnds, Corner, Beside };

Fate fateAt(const Segment& line, const Window& window)
{
    const unsigned a = clipping::outcodeOf(line.a, window), b = clipping::outcodeOf(line.b, window);
    if ((a & b) != 0)
        return Fate::Beside;
    if ((a | b) == 0)
        return Fate::Inside;
    if (!clipped(exactVariant(), line, window))
        return Fate::Corner;
    return a != 0 && b != 0 ? Fate::BothEnds : Fate::OneEnd;
}

/// Whether a line has a fate, also at a window that is a little smaller or larger, so that the eye
/// can tell; and is long enough to be read.
bool clearlyHas(const TracedLine& traced, Fate fate)
{
    const Point middle = middleOf(traced.window), half = halfOf(traced.window);
    const auto has = [&](double size) {
        return fateAt(traced.line, {middle - size * half, middle + size * half}) == fate;
    };
    return glm::distance(traced.line.a, traced.line.b) > half.x / 2 && has(0.94) && has(1)
           && has(1.06);
}

template <Fate fate>
bool isOf(const TracedLine& traced)
{
    return clearlyHas(traced, fate);
}

/// End 1 is right of the window, neither above nor below it; End 2 is anywhere.
bool beginsAtTheRight(const TracedLine& traced)
{
    const Point step = 0.06 * halfOf(traced.window);
    const auto isClear = [&](const Point& p) {
        const Window smaller{traced.window.min + step, traced.window.max - step},
            larger{traced.window.min - step, traced.window.max + step};
        return clipping::outcodeOf(p, smaller) == clipping::outcodeOf(p, larger);
    };
    return clipping::outcodeOf(traced.line.a, traced.window) == clipping::outcode::right
           && isClear(traced.line.a) && isClear(traced.line.b)
           && glm::distance(traced.line.a, traced.line.b) > halfOf(traced.window).x / 2;
}

/// A horizontal line to the right across the lines of the left and right edges.
Segment level(Random& random, const Window& window)
{
    const double step = readableStep(window), y = wholeBetween(random, -5, 14) * step;
    const double left = window.min.x - wholeBetween(random, 2, 8) * step;
    return {{left, y}, {window.max.x + wholeBetween(random, 2, 8) * step, y}};
}
bool isLevel(const TracedLine& traced)
{
    const auto& [a, b] = traced.line;
    const double y = a.y, gap = 0.06 * halfOf(traced.window).y;
    return a.y == b.y && a.x < traced.window.min.x && b.x > traced.window.max.x
           && y > traced.window.min.y + gap && std::abs(y - traced.window.max.y) > gap;
}

/// A line so steep that its visible part is clearly shorter or longer than 1 in x.
Segment steep(Random& random, const Window& window)
{
    const double step = readableStep(window), x = wholeBetween(random, -8, 8) * step;
    const double across =
        random.heads() ? wholeBetween(random, 2, 7) / 8.0 : double(wholeBetween(random, 4, 9));
    const Segment up{{x, window.min.y - 8 * step}, {x + across, window.max.y + 8 * step}};
    return random.heads() ? up : Segment{up.b, up.a};
}
bool isSteep(const TracedLine& traced)
{
    return clearlyHas(traced, Fate::BothEnds)
           && std::abs(traced.line.a.x - traced.line.b.x) < halfOf(traced.window).x / 10;
}

/// Exactly through the lower left corner of a window whose corner has two equal coordinates.
Segment diagonal(Random& random, const Window&)
{
    const double from = wholeBetween(random, 5, 29) / 10.0,
                 to = -wholeBetween(random, 2, 30) / 10.0;
    return {{from, from}, {to, to}};
}
/// After rounding, the published Cohen-Sutherland cuts it without end.
bool isCutForEver(const TracedLine& traced)
{
    static const Variant published = *findVariant(QStringLiteral("cs:published"));
    const auto* functions = clipping::functionsOf(*published.algorithm, published.form);
    return traced.line.a.x == traced.line.a.y && traced.line.b.x == traced.line.b.y
           && traced.window.min.x == traced.window.min.y
           && functions->trace(traced.line, traced.window).outcome == clipping::Outcome::DidNotEnd;
}

/// Beside the upper right corner of the unit square, by less than a rounding error.
Segment pastCorner(Random& random, const Window& window)
{
    constexpr double ulp = 0x1p-52;
    return {{window.min.x - wholeBetween(random, 1, 9),
             window.max.y + wholeBetween(random, 1, 6) * ulp},
            {window.max.x + wholeBetween(random, 1, 9), window.max.y - ulp / 2}};
}
/// The published method of 2019 shows a part, though nothing is visible.
bool isShownWrongly(const TracedLine& traced)
{
    static const Variant published = *findVariant(QStringLiteral("md:published"));
    return !clipped(exactVariant(), traced.line, traced.window)
           && clipped(published, traced.line, traced.window);
}

/// Exactly on the bottom or top edge, and beyond it at one end.
Segment alongEdge(Random& random, const Window& window)
{
    const double step = readableStep(window), y = random.heads() ? window.min.y : window.max.y;
    const double from = window.min.x - wholeBetween(random, 1, 8) * step,
                 to = from + wholeBetween(random, 14, 34) * step;
    return random.heads() ? Segment{{from, y}, {to, y}} : Segment{{to, y}, {from, y}};
}
bool isAlongEdge(const TracedLine& traced)
{
    const auto& [a, b] = traced.line;
    const auto isInside = [&](const Point& p) {
        return clipping::outcodeOf(p, traced.window) == 0;
    };
    const auto seen = clipped(exactVariant(), traced.line, traced.window);
    return a.y == b.y && (a.y == traced.window.min.y || a.y == traced.window.max.y)
           && isInside(a) != isInside(b) && seen
           && glm::distance(seen->a, seen->b) > halfOf(traced.window).x / 2;
}

/// Through the middle of the window, with coordinates whose products are infinite.
Segment huge(Random& random, const Window& window)
{
    const Point far{wholeBetween(random, 1, 9) * 1e200, wholeBetween(random, 1, 9) * 1e200};
    const Point end{far.x, random.heads() ? far.y : -far.y};
    return random.heads() ? Segment{middleOf(window) - end, middleOf(window) + end}
                          : Segment{middleOf(window) + end, middleOf(window) - end};
}
bool isHuge(const TracedLine& traced)
{
    return clipped(exactVariant(), traced.line, traced.window) && std::abs(traced.line.a.x) >= 1e200
           && std::abs(traced.line.a.y) >= 1e200;
}

} // namespace

// THE CATALOGUE. To add a family: its two functions, a line here, and its row in the README of the
// lessons.
std::span<const LineFamily> lineFamilies()
{
    // clang-format off
    static constexpr std::array all{
        LineFamily{"inside", anywhere, isOf<Fate::Inside>},
        LineFamily{"one-end", anywhere, isOf<Fate::OneEnd>},
        LineFamily{"both-ends", anywhere, isOf<Fate::BothEnds>},
        LineFamily{"corner", anywhere, isOf<Fate::Corner>},
        LineFamily{"beside", anywhere, isOf<Fate::Beside>},
        LineFamily{"end-1-right", anywhere, beginsAtTheRight},
        LineFamily{"level", level, isLevel},
        LineFamily{"steep", steep, isSteep},
        LineFamily{"diagonal", diagonal, isCutForEver},
        LineFamily{"past-corner", pastCorner, isShownWrongly},
        LineFamily{"along-edge", alongEdge, isAlongEdge},
        LineFamily{"huge", huge, isHuge},
    };
    // clang-format on
    return all;
}

const LineFamily* findLineFamily(QStringView key)
{
    const auto all = lineFamilies();
    const auto found =
        std::ranges::find_if(all, [&](const LineFamily& f) { return latin(f.key) == key; });
    return found == all.end() ? nullptr : &*found;
}

} // namespace app
