// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/clipping/inputs.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/clipping/random.h"

using clipping::Segment;
using clipping::Window;

namespace {

template <class T>
Window rounded(const Window& w)
{
    return {{T(w.min.x), T(w.min.y)}, {T(w.max.x), T(w.max.y)}};
}
template <class T>
Segment rounded(const Segment& s)
{
    return {{T(s.a.x), T(s.a.y)}, {T(s.b.x), T(s.b.y)}};
}

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
template <class T>
std::vector<Input> corners()
{
    Random r(11);
    std::vector<Input> all(100'000);
    for (auto& [s, w] : all) {
        w = rounded<T>(someWindow(r));
        const glm::dvec2 corner{r.whole(0, 1) ? w.min.x : w.max.x,
                                r.whole(0, 1) ? w.min.y : w.max.y};
        const double angle = r.between(0, 6.3), back = r.whole(0, 3) ? r.between(0, 8) : 0;
        const double on = r.whole(0, 3) ? r.between(0, 8) : 0;
        const glm::dvec2 d{std::cos(angle), std::sin(angle)};
        s = {corner - back * d, corner + on * d};
        for (double* x : {&s.a.x, &s.a.y, &s.b.x, &s.b.y})
            *x = nudged<T>(*x, r.whole(-3, 3));
    }
    return all;
}

/// Lines along an edge, within a few ulps of it at both ends, and a little askew.
template <class T>
std::vector<Input> edges()
{
    Random r(12);
    std::vector<Input> all(100'000);
    for (auto& [s, w] : all) {
        w = rounded<T>(someWindow(r));
        const int along = r.whole(0, 1), across = 1 - along;
        const double level = r.whole(0, 1) ? w.min[across] : w.max[across];
        const double askew = r.whole(0, 1) ? r.between(-1, 1) * 450 * Limits<T>::epsilon() : 0;
        for (auto* p : {&s.a, &s.b}) {
            (*p)[along] = r.whole(0, 4) ? r.between(-5, 5) * (w.max[along] - w.min[along] + 1)
                                        : nudged<T>(w.min[along], r.whole(-2, 2));
            (*p)[across] = nudged<T>(level, r.whole(-4, 4)) + (p == &s.a ? askew : -askew);
        }
        s = rounded<T>(s);
    }
    return all;
}

/// Lengths of up to 1e15 (6e6 in float) against a unit window, most of them aimed at it.
template <class T>
std::vector<Input> longLines()
{
    Random r(13);
    std::vector<Input> all(100'000);
    for (auto& [s, w] : all) {
        w = {{0, 0}, {1, 1}};
        const double angle = r.between(0, 6.3),
                     length = std::pow(10, r.between(9, 15) * Limits<T>::digits / 53);
        const glm::dvec2 d{std::cos(angle), std::sin(angle)};
        const glm::dvec2 through{r.between(-0.2, 1.2), r.between(-0.2, 1.2)};
        const double part = r.whole(0, 2) ? r.unit() : r.whole(0, 1);
        s = rounded<T>(Segment{through - part * length * d, through + (1 - part) * length * d});
    }
    return all;
}

/// Any number at any place.
template <class T>
std::vector<Input> mixed()
{
    Random r(14);
    std::vector<Input> all(100'000);
    for (auto& [s, w] : all) {
        const auto any = [&] { return anyNumber<T>(r); };
        s = {{any(), any()}, {any(), any()}};
        w = ordered(any(), any(), any(), any());
    }
    return all;
}

/// Lines about a window, all of one size on each axis, from denormal to where differences overflow.
template <class T>
std::vector<Input> scaled()
{
    Random r(15);
    std::vector<Input> all(100'000);
    for (auto& [s, w] : all) {
        const auto power = [&] {
            return std::ldexp(1.0, r.whole(leastExponent<T> - 1, mostExponent<T>));
        };
        const glm::dvec2 size{power(), power()};
        const auto point = [&] {
            return glm::dvec2{r.between(-1.9, 1.9), r.between(-1.9, 1.9)} * size;
        };
        s = rounded<T>(Segment{point(), point()});
        const glm::dvec2 p = 0.5 * point(), q = 0.5 * point();
        w = rounded<T>(ordered(p.x, p.y, q.x, q.y));
    }
    return all;
}

/// A small picture far away from zero.
template <class T>
std::vector<Input> offset()
{
    Random r(16);
    std::vector<Input> all(100'000);
    for (auto& [s, w] : all) {
        const auto far = [&] {
            return std::ldexp(r.between(-1, 1), r.whole(0, 60 * Limits<T>::digits / 53));
        };
        const glm::dvec2 origin{far(), far()};
        const auto point = [&] { return origin + glm::dvec2{r.between(-9, 9), r.between(-9, 9)}; };
        s = rounded<T>(Segment{point(), point()});
        const glm::dvec2 p = point(), q = point();
        w = rounded<T>(ordered(p.x, p.y, q.x, q.y));
    }
    return all;
}

template <class T>
std::vector<Input> sceneIn()
{
    Random r(17);
    const auto point = [&] { return glm::dvec2{r.between(-960, 960), r.between(-720, 720)}; };
    std::vector<Input> all(1'000'000);
    for (auto& [s, w] : all) {
        s = rounded<T>(Segment{point(), point()});
        w = {{-100, -75}, {100, 75}};
    }
    return all;
}

template <class T>
std::span<const Family> familiesIn()
{
    static constexpr std::array all{
        Family{"grid", madeOnce<grid>},        Family{"corners", madeOnce<corners<T>>},
        Family{"edges", madeOnce<edges<T>>},   Family{"long", madeOnce<longLines<T>>},
        Family{"mixed", madeOnce<mixed<T>>},   Family{"scaled", madeOnce<scaled<T>>},
        Family{"offset", madeOnce<offset<T>>}, Family{"scene", madeOnce<sceneIn<T>>},
    };
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

std::vector<Input> scene() { return sceneIn<double>(); }
std::span<const Family> families() { return familiesIn<double>(); }
std::span<const Family> singleFamilies() { return familiesIn<float>(); }
