// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/clipping/blocks.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <random>

namespace {

/// The limits of the numbers of a kind, as doubles.
struct Range {
    double least, most, epsilon;
};
template <class T>
constexpr Range rangeOf{std::numeric_limits<T>::denorm_min(), std::numeric_limits<T>::max(),
                        std::numeric_limits<T>::epsilon()};

class Source {
public:
    Source(Numbers numbers, unsigned seed)
        : engine_(seed), single_(numbers == Numbers::PlaneInFloat),
          range(single_ ? rangeOf<float> : rangeOf<double>)
    {
    }
    int whole(int low, int high) { return low + int(engine_() % std::uint64_t(high - low + 1)); }
    double between(double low, double high)
    {
        return rounded(low + double(engine_() >> 11) * 0x1p-53 * (high - low));
    }
    double finite()
    {
        for (;;) {
            const double x = single_ ? double(std::bit_cast<float>(std::uint32_t(engine_())))
                                     : std::bit_cast<double>(engine_());
            if (std::isfinite(x))
                return x;
        }
    }
    double rounded(double x) const { return single_ ? double(float(x)) : x; }
    bool single() const { return single_; }

private:
    std::mt19937_64 engine_;
    bool single_;

public:
    const Range range;
};

using Number = std::function<double(Source&)>; ///< one coordinate
struct Family {
    const char* name;
    Number number;
    double low, high; ///< of the window
};

int numbersOf(Numbers numbers) { return numbers == Numbers::Space ? 6 : 4; }

double special(Source& from)
{
    const auto& [least, most, epsilon] = from.range;
    const double inf = std::numeric_limits<double>::infinity();
    const std::array all{0.0, -0.0, 1.0,     -1.0, 0.5,          least, -least, most,       -most,
                         inf, -inf, epsilon, 2.0,  std::nan(""), 3.0,   -3.0,   1 + epsilon};
    return all[std::size_t(from.whole(0, int(all.size()) - 1))];
}

double longLength(Source& from)
{
    const int exponent = from.whole(0, from.single() ? 20 : 48); // first: compilers differ in the order of arguments
    return from.rounded(std::ldexp(from.between(-1, 1), exponent));
}

/// A window from low to high on each axis, moved a little from axis to axis.
std::vector<double> windowOf(Numbers numbers, double low, double high)
{
    if (numbers == Numbers::Space)
        return {low, low / 2, low, high, high, high / 2};
    return {low, low / 2, high, high};
}

std::vector<Family> families(const Range& range)
{
    const auto whole = [](int low, int high, double unit) {
        return [=](Source& from) { return from.rounded(from.whole(low, high) * unit); };
    };
    const double least = range.least, most = range.most, epsilon = range.epsilon;
    return {
        {"paper", [](Source& from) { return from.between(-960, 960); }, -100, 75},
        {"inside mostly", [](Source& from) { return from.between(-110, 80); }, -100, 75},
        {"whole", whole(-6, 6, 1), -2, 3},
        {"tenths", whole(-15, 25, 0.1), 0.1, 0.7},
        {"no extent", whole(-4, 4, 1), 0, 0},
        {"long", longLength, -100, 75},
        {"along an edge",
         [=](Source& from) {
             const double edge = from.whole(0, 1) ? -1.0 : 1.0;
             return from.whole(0, 2) == 0 ? from.between(-3, 3)
                                          : from.rounded(edge + from.whole(-8, 8) * epsilon);
         },
         -1, 1},
        {"finite", [](Source& from) { return from.finite(); }, -1, 1},
        {"finite in all", [](Source& from) { return from.finite(); }, -most / 2, most / 4},
        {"ordinary and extreme",
         [](Source& from) {
             return from.whole(0, 3) == 0 ? from.finite() : double(from.whole(-4, 4));
         },
         -2, 3},
        {"denormal", whole(-6, 6, least), -2 * least, 3 * least},
        {"largest", whole(-4, 4, most / 4), -most, most / 2},
        {"special", special, -1, 1},
        {"special in a point", special, 0, 0},
        {"inverted", whole(-4, 4, 1), 1, -1},
    };
}

/// Every segment between the points of a grid of 7 × 7 (3 × 3 × 3 in space).
Block grid(Numbers numbers, std::vector<double> window)
{
    Block block{"grid", std::move(window), {}};
    const int axes = numbersOf(numbers) / 2, side = axes == 2 ? 7 : 3;
    const int points = axes == 2 ? 49 : 27;
    const auto add = [&](int point) {
        for (int k = 0; k < axes; ++k, point /= side)
            block.segments.push_back(point % side);
    };
    for (int p = 0; p < points; ++p)
        for (int q = 0; q < points; ++q)
            add(p), add(q);
    return block;
}

std::vector<std::vector<double>> polygons(const Range& range)
{
    std::vector<double> parabola;
    for (int i = -30; i <= 30; ++i)
        parabola.insert(parabola.end(), {double(i), i * i / 16.0});
    const double big = range.most / 4, tiny = range.least;
    return {
        {-2, -1, 3, -1, 3, 3, -2, 3},                         // a rectangle
        {-3, -2, 4, -1, 1, 5},                                // a triangle
        {0, 0, 4, 0, 6, 2, 6, 4, 3, 6, 1, 5, -1, 2},          // seven corners
        parabola,                                             // sixty-one
        {0, 0, 2, 0, 4, 0, 4, 4, 4, 4, 0, 4},                 // corners on a line, and one twice
        {0, 0, 3, 3},                                         // flat
        {1, 1},                                               // a point
        {0, 0, 0, 4, 4, 4, 4, 0},                             // clockwise: contains nothing
        {-big, -big, big, -big, 0, big},                      // huge
        {-2 * tiny, -tiny, 3 * tiny, -tiny, 0, 4 * tiny},     // of denormals
        {-1000, -1e-9, 1000, -1e-9, 1000, 1e-9, -1000, 1e-9}, // slim
        {},
    };
}

void fill(Block& block, const Number& number, std::size_t count, Source& from, int numbers)
{
    for (std::size_t i = 0; i < count * std::size_t(numbers); ++i)
        block.segments.push_back(number(from));
}

} // namespace

std::vector<Block> hardBlocks(Numbers numbers, std::size_t count)
{
    std::vector<Block> blocks;
    Source from(numbers, 20190703);
    const bool polygon = numbers == Numbers::Polygon;
    const auto windows = polygon ? polygons(from.range) : std::vector<std::vector<double>>{{}};
    for (const Family& family : families(from.range))
        for (std::size_t i = 0; i < windows.size(); ++i) {
            Block block{family.name, windows[i], {}};
            if (polygon)
                block.name += ", polygon " + std::to_string(i);
            else
                block.window =
                    windowOf(numbers, from.rounded(family.low), from.rounded(family.high));
            fill(block, family.number, polygon ? count / 4 : count, from, numbersOf(numbers));
            blocks.push_back(std::move(block));
        }
    if (numbers == Numbers::Space)
        for (const auto& w : {std::vector<double>{1, 1, 1, 2, 2, 2},
                              {1, 0, 0, 1, 2, 2},
                              {1, 1, 0, 1, 1, 2},
                              {1, 1, 1, 1, 1, 1}})
            blocks.push_back(grid(numbers, w));
    else if (polygon)
        for (const auto& corners : windows)
            blocks.push_back(grid(numbers, corners));
    else
        for (const auto& w : {std::vector<double>{2, 2, 4, 5},
                              {3, 1, 3, 5},
                              {1, 3, 5, 3},
                              {3, 3, 3, 3},
                              {0, 0, 6, 6}})
            blocks.push_back(grid(numbers, w));
    return blocks;
}
