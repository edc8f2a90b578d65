// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/clipping/box/inputs.h"

#include "clipping/geometry.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "tests/clipping/random.h"

using clipping::Segment3;
using clipping::Window3;
using glm::dvec3;

namespace {

Window3 ordered(const dvec3& p, const dvec3& q) { return {glm::min(p, q), glm::max(p, q)}; }

dvec3 point(Random& r, double reach)
{
    return {r.between(-reach, reach), r.between(-reach, reach), r.between(-reach, reach)};
}
dvec3 tenths(Random& r)
{
    return {r.whole(-20, 20) / 10.0, r.whole(-20, 20) / 10.0, r.whole(-20, 20) / 10.0};
}

Window3 someBox(Random& r)
{
    switch (r.whole(0, 3)) {
    case 0:
        return {{-100, -75, -50}, {100, 75, 50}};
    case 1:
        return {{0, 0, 0}, {1, 1, 1}};
    case 2:
        return ordered(tenths(r), tenths(r));
    default:
        return ordered(point(r, 3), point(r, 3));
    }
}

constexpr int many = 50'000;

template <class Make>
std::vector<BoxInput> inputs(unsigned seed, Make make)
{
    Random r(seed);
    std::vector<BoxInput> all;
    for (int i = 0; i < many; ++i)
        all.push_back(make(r));
    return all;
}

/// Lines in all directions through and about some box.
std::vector<BoxInput> plain()
{
    return inputs(31, [](Random& r) {
        const Window3 w = someBox(r);
        const dvec3 size = w.max - w.min + 0.1;
        return BoxInput{
            {w.min + size * (point(r, 1.5) + 0.5), w.min + size * (point(r, 1.5) + 0.5)}, w};
    });
}

/// Lines that pass an edge or a corner of the box, or end at it, within a few ulps.
std::vector<BoxInput> edges()
{
    return inputs(32, [](Random& r) {
        const Window3 w = someBox(r);
        dvec3 on;
        for (int k = 0; k < 3; ++k)
            on[k] = r.whole(0, 1) ? w.min[k] : w.max[k];
        if (const int along = r.whole(0, 3); along < 3) // 3: a corner
            on[along] = r.between(w.min[along], w.max[along]);
        const dvec3 d = point(r, 1);
        const double back = r.whole(0, 3) ? r.between(0, 8) : 0;
        const double ahead = r.whole(0, 3) ? r.between(0, 8) : 0;
        BoxInput input{{on - back * d, on + ahead * d}, w};
        for (auto* p : {&input.segment.a, &input.segment.b})
            for (int k = 0; k < 3; ++k)
                (*p)[k] = nudged((*p)[k], r.whole(-3, 3));
        return input;
    });
}

/// Lines along a side or an edge, within a few ulps of it at both ends, and a little askew.
std::vector<BoxInput> sides()
{
    return inputs(33, [](Random& r) {
        BoxInput input{{}, someBox(r)};
        const Window3& w = input.window;
        const int along = r.whole(0, 2), free = r.whole(0, 3);
        const double askew = r.whole(0, 1) ? r.between(-1, 1) * 1e-13 : 0;
        dvec3 level;
        for (int k = 0; k < 3; ++k)
            level[k] = k == free ? r.between(-3, 3) : r.whole(0, 1) ? w.min[k] : w.max[k];
        for (auto* p : {&input.segment.a, &input.segment.b})
            for (int k = 0; k < 3; ++k)
                (*p)[k] = k == along ? r.between(-5, 5) * (w.max[k] - w.min[k] + 1)
                                     : nudged(level[k], r.whole(-4, 4))
                                           + (p == &input.segment.a ? askew : -askew);
        return input;
    });
}

/// Lengths of 1e15 against the unit box, most of them aimed at it.
std::vector<BoxInput> longLines()
{
    return inputs(34, [](Random& r) {
        const dvec3 d = point(r, 1) * std::pow(10, r.between(9, 15));
        const dvec3 through = 0.5 + point(r, 0.7);
        const double part = r.whole(0, 2) ? r.unit() : r.whole(0, 1);
        return BoxInput{{through - part * d, through + (1 - part) * d}, {{0, 0, 0}, {1, 1, 1}}};
    });
}

/// Any number at any place.
std::vector<BoxInput> mixed()
{
    return inputs(35, [](Random& r) {
        const auto any = [&] { return dvec3{anyNumber(r), anyNumber(r), anyNumber(r)}; };
        const Segment3 s{any(), any()};
        return BoxInput{s, ordered(any(), any())};
    });
}

/// Lines about a box, all of one size on each axis, from denormal to where differences overflow.
std::vector<BoxInput> scaled()
{
    return inputs(36, [](Random& r) {
        dvec3 size;
        for (int k = 0; k < 3; ++k)
            size[k] = std::ldexp(1.0, r.whole(-1075, 1023));
        const Segment3 s{point(r, 1.9) * size, point(r, 1.9) * size};
        return BoxInput{s, ordered(point(r, 0.95) * size, point(r, 0.95) * size)};
    });
}

/// A small picture far away from zero.
std::vector<BoxInput> offset()
{
    return inputs(37, [](Random& r) {
        dvec3 origin;
        for (int k = 0; k < 3; ++k)
            origin[k] = std::ldexp(r.between(-1, 1), r.whole(0, 60));
        const auto near = [&] { return origin + point(r, 9); };
        const Segment3 s{near(), near()};
        return BoxInput{s, ordered(near(), near())};
    });
}

} // namespace

std::vector<BoxInput> boxGrid()
{
    constexpr int n = 5;
    constexpr std::array boxes{
        Window3{{1, 1, 1}, {3, 3, 3}}, Window3{{1, 2, 1}, {2, 3, 4}}, Window3{{0, 0, 0}, {4, 4, 4}},
        Window3{{1, 2, 1}, {3, 2, 3}}, Window3{{2, 1, 1}, {2, 1, 3}}, Window3{{2, 2, 2}, {2, 2, 2}},
        Window3{{0, 1, 4}, {4, 3, 4}},
    };
    const auto at = [](int i) { return dvec3{i % n, i / n % n, i / n / n}; };
    std::vector<BoxInput> all;
    for (const Window3& w : boxes)
        for (int i = 0; i < n * n * n; ++i)
            for (int j = 0; j < n * n * n; ++j)
                all.push_back({{at(i), at(j)}, w});
    return all;
}

std::span<const BoxFamily> boxFamilies()
{
    static constexpr std::array all{
        BoxFamily{"grid", madeOnce<boxGrid>},   BoxFamily{"plain", madeOnce<plain>},
        BoxFamily{"edges", madeOnce<edges>},    BoxFamily{"sides", madeOnce<sides>},
        BoxFamily{"long", madeOnce<longLines>}, BoxFamily{"mixed", madeOnce<mixed>},
        BoxFamily{"scaled", madeOnce<scaled>},  BoxFamily{"offset", madeOnce<offset>},
    };
    return all;
}
