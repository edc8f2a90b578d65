// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/teaching/formulas/lines.h"

#include <algorithm>

#include "tests/clipping/random.h"
#include "tests/clipping/scenes.h"

namespace app::formulas {

namespace {

using clipping::Segment, clipping::Window;
using Point = glm::dvec2;

/// Also one whose middle is exactly 1 from its edges: a published form asks for lines that long.
constexpr std::array windows{
    Window{{-100, -75}, {100, 75}}, Window{{0.1, 0.1}, {3, 3}},
    Window{{-3, -1}, {-1, 1}},      Window{{10, -300.7}, {11.3, 400}},
    Window{{1, -2}, {1, 2}},        Window{{-3, 0.5}, {4, 0.5}},
    Window{{1, 1}, {1, 1}},
};

double size(const Window& w) { return std::max({w.max.x - w.min.x, w.max.y - w.min.y, 1.0}); }

Segment ofAnySize(RandomNumbers& random, const Window& w)
{
    const double reach = size(w) * std::exp2(random.uniform(-3, 3));
    const double far = random.integer(0, 9) == 0 ? std::exp2(random.uniform(0, 60)) : 1;
    const auto point = [&] {
        const double x = (w.min.x + w.max.x) / 2 + random.uniform(-reach, reach) * far;
        return Point{x, (w.min.y + w.max.y) / 2 + random.uniform(-reach, reach) * far};
    };
    const Point a = point();
    return {a, point()};
}

/// Ends on a grid of 7 x 7 points, where lines 2 and 4 are the window's edges.
Point onGrid(RandomNumbers& random, const Window& w)
{
    const auto at = [&](double low, double high) {
        const double step = high > low ? (high - low) / 2 : 1;
        const int k = random.integer(0, 6);
        return k == 2 ? low : k == 4 ? high : low + (k - 2) * step;
    };
    const double x = at(w.min.x, w.max.x);
    return {x, at(w.min.y, w.max.y)};
}
Segment betweenGridPoints(RandomNumbers& random, const Window& w)
{
    const Point a = onGrid(random, w);
    return {a, onGrid(random, w)};
}

/// Through a corner by small whole numbers, and mostly a few ulps beside it.
Segment throughCorner(RandomNumbers& random, const Window& w)
{
    const Point corner{random.integer(0, 1) ? w.max.x : w.min.x,
                       random.integer(0, 1) ? w.max.y : w.min.y};
    const double unit = size(w) / 4, dx = unit * random.integer(-5, 5);
    const Point d{dx, unit * random.integer(-5, 5)};
    Segment s{corner - double(random.integer(1, 4)) * d, corner + double(random.integer(1, 4)) * d};
    for (double* x : {&s.a.x, &s.a.y, &s.b.x, &s.b.y})
        if (random.integer(0, 2) == 0)
            *x = nudged(*x, random.integer(-2, 2));
    return s;
}

Segment alongAnAxis(RandomNumbers& random, const Window& w)
{
    Segment s = random.integer(0, 1) ? ofAnySize(random, w) : betweenGridPoints(random, w);
    const bool isPoint = random.integer(0, 4) == 0, isHorizontal = random.integer(0, 1) == 0;
    if (isPoint || isHorizontal)
        s.b.y = s.a.y;
    if (isPoint || !isHorizontal)
        s.b.x = s.a.x;
    return s;
}

constexpr std::array kinds{ofAnySize, betweenGridPoints, throughCorner, alongAnAxis};

} // namespace

std::vector<Input> inputs()
{
    RandomNumbers random(12);
    std::vector<Input> all;
    for (std::size_t i = 0; i < 10'000; ++i) {
        // Most windows have extent; every window meets every kind.
        const Window& window = windows[i / kinds.size() % windows.size()];
        all.push_back({kinds[i % kinds.size()](random, window), window});
    }
    return all;
}

} // namespace app::formulas
