// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/clipping/inputs.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/clipping/random.h"

using clipping::Segment;
using clipping::Window;

namespace {

Window ordered(double x0, double y0, double x1, double y1)
{
    return {{std::min(x0, x1), std::min(y0, y1)}, {std::max(x0, x1), std::max(y0, y1)}};
}

Window someWindow(Random& r)
{
    switch (r.whole(0, 3)) {
    case 0:
        return {{-100, -75}, {100, 75}};
    case 1:
        return {{0, 0}, {1, 1}};
    case 2:
        return ordered(r.whole(-20, 20) / 10.0, r.whole(-20, 20) / 10.0, r.whole(-20, 20) / 10.0,
                       r.whole(-20, 20) / 10.0);
    default:
        return ordered(r.between(-3, 3), r.between(-3, 3), r.between(-3, 3), r.between(-3, 3));
    }
}

/// Lines that pass a corner, or end at it, within a few ulps.
std::vector<Input> corners()
{
    Random r(11);
    std::vector<Input> all(100'000);
    for (auto& [s, w] : all) {
        w = someWindow(r);
        const glm::dvec2 corner{r.whole(0, 1) ? w.min.x : w.max.x,
                                r.whole(0, 1) ? w.min.y : w.max.y};
        const double angle = r.between(0, 6.3), back = r.whole(0, 3) ? r.between(0, 8) : 0;
        const double on = r.whole(0, 3) ? r.between(0, 8) : 0;
        const glm::dvec2 d{std::cos(angle), std::sin(angle)};
        s = {corner - back * d, corner + on * d};
        for (double* x : {&s.a.x, &s.a.y, &s.b.x, &s.b.y})
            *x = nudged(*x, r.whole(-3, 3));
    }
    return all;
}

/// Lines along an edge, within a few ulps of it at both ends, and a little askew.
std::vector<Input> edges()
{
    Random r(12);
    std::vector<Input> all(100'000);
    for (auto& [s, w] : all) {
        w = someWindow(r);
        const int along = r.whole(0, 1), across = 1 - along;
        const double level = r.whole(0, 1) ? w.min[across] : w.max[across];
        const double askew = r.whole(0, 1) ? r.between(-1, 1) * 1e-13 : 0;
        for (auto* p : {&s.a, &s.b}) {
            (*p)[along] = r.whole(0, 4) ? r.between(-5, 5) * (w.max[along] - w.min[along] + 1)
                                        : nudged(w.min[along], r.whole(-2, 2));
            (*p)[across] = nudged(level, r.whole(-4, 4)) + (p == &s.a ? askew : -askew);
        }
    }
    return all;
}

/// Lengths of 1e15 against a unit window, most of them aimed at it.
std::vector<Input> longLines()
{
    Random r(13);
    std::vector<Input> all(100'000);
    for (auto& [s, w] : all) {
        w = {{0, 0}, {1, 1}};
        const double angle = r.between(0, 6.3), length = std::pow(10, r.between(9, 15));
        const glm::dvec2 d{std::cos(angle), std::sin(angle)};
        const glm::dvec2 through{r.between(-0.2, 1.2), r.between(-0.2, 1.2)};
        const double part = r.whole(0, 2) ? r.unit() : r.whole(0, 1);
        s = {through - part * length * d, through + (1 - part) * length * d};
    }
    return all;
}

/// Any number at any place.
std::vector<Input> mixed()
{
    Random r(14);
    std::vector<Input> all(100'000);
    for (auto& [s, w] : all) {
        s = {{anyNumber(r), anyNumber(r)}, {anyNumber(r), anyNumber(r)}};
        w = ordered(anyNumber(r), anyNumber(r), anyNumber(r), anyNumber(r));
    }
    return all;
}

/// Lines about a window, all of one size on each axis, from denormal to where differences overflow.
std::vector<Input> scaled()
{
    Random r(15);
    std::vector<Input> all(100'000);
    for (auto& [s, w] : all) {
        const glm::dvec2 size{std::ldexp(1.0, r.whole(-1075, 1023)),
                              std::ldexp(1.0, r.whole(-1075, 1023))};
        const auto point = [&] {
            return glm::dvec2{r.between(-1.9, 1.9), r.between(-1.9, 1.9)} * size;
        };
        s = {point(), point()};
        const glm::dvec2 p = 0.5 * point(), q = 0.5 * point();
        w = ordered(p.x, p.y, q.x, q.y);
    }
    return all;
}

/// A small picture far away from zero.
std::vector<Input> offset()
{
    Random r(16);
    std::vector<Input> all(100'000);
    for (auto& [s, w] : all) {
        const glm::dvec2 origin{std::ldexp(r.between(-1, 1), r.whole(0, 60)),
                                std::ldexp(r.between(-1, 1), r.whole(0, 60))};
        const auto point = [&] { return origin + glm::dvec2{r.between(-9, 9), r.between(-9, 9)}; };
        s = {point(), point()};
        const glm::dvec2 p = point(), q = point();
        w = ordered(p.x, p.y, q.x, q.y);
    }
    return all;
}

} // namespace

std::vector<Input> grid()
{
    constexpr int n = 7;
    constexpr std::array windows{
        Window{{2, 1}, {4, 5}}, Window{{1, 1}, {5, 5}}, Window{{2, 3}, {3, 4}},
        Window{{0, 0}, {6, 6}}, Window{{1, 3}, {5, 3}}, Window{{2, 1}, {2, 4}},
        Window{{3, 3}, {3, 3}}, Window{{0, 0}, {6, 0}},
    };
    std::vector<Input> all;
    for (const Window& w : windows)
        for (int i = 0; i < n * n * n * n; ++i)
            all.push_back({{{i % n, i / n % n}, {i / n / n % n, i / n / n / n}}, w});
    return all;
}

std::vector<Input> scene()
{
    Random r(17);
    const auto point = [&] { return glm::dvec2{r.between(-960, 960), r.between(-720, 720)}; };
    std::vector<Input> all(1'000'000);
    for (auto& [s, w] : all) {
        s.a = point();
        s.b = point();
        w = {{-100, -75}, {100, 75}};
    }
    return all;
}

std::span<const Family> families()
{
    static constexpr std::array all{
        Family{"grid", grid},      Family{"corners", corners}, Family{"edges", edges},
        Family{"long", longLines}, Family{"mixed", mixed},     Family{"scaled", scaled},
        Family{"offset", offset},  Family{"scene", scene},
    };
    return all;
}
