// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/style_table.h"

#include <QHashFunctions>

#include <algorithm>
#include <bit>
#include <cassert>
#include <functional>

namespace app {
namespace {

constexpr std::size_t firstStep = 256;

struct Place {
    std::size_t step, at;
};
Place placeOf(StyleIndex index)
{
    const std::size_t n = index / firstStep + 1;
    const std::size_t step = std::size_t(std::bit_width(n)) - 1;
    return {step, index - firstStep * ((std::size_t(1) << step) - 1)};
}

std::uint64_t bits(double number) { return std::bit_cast<std::uint64_t>(number); }

std::uint64_t bits(const std::optional<Colour>& colour)
{
    return colour ? std::uint64_t(1) << 32 | std::bit_cast<std::uint32_t>(*colour) : 0;
}

bool sameStyleBits(const Style& a, const Style& b)
{
    return a.stroke == b.stroke && a.fill == b.fill && bits(a.width) == bits(b.width)
           && bits(a.miterLimit) == bits(b.miterLimit) && bits(a.dashOffset) == bits(b.dashOffset)
           && a.cap == b.cap && a.join == b.join && a.fillRule == b.fillRule
           && std::ranges::equal(a.dashes, b.dashes,
                                 [](double x, double y) { return bits(x) == bits(y); });
}

std::size_t hashOf(const Style& style)
{
    static const std::uint64_t seed =
        QHashSeed::globalSeed(); // random, so that collisions cannot be crafted
    std::uint64_t hash = seed
                         ^ (std::uint64_t(style.cap) << 4 | std::uint64_t(style.join) << 2
                            | std::uint64_t(style.fillRule));
    const auto mix = [&hash](std::uint64_t word) { // Fibonacci hashing, a word at a time
        hash = (std::rotl(hash, 29) ^ word) * 0x9E3779B97F4A7C15U;
    };
    mix(bits(style.stroke));
    mix(bits(style.fill));
    for (const double number : {style.width, style.miterLimit, style.dashOffset})
        mix(bits(number));
    for (const double dash : style.dashes)
        mix(bits(dash));
    return hash ^ hash >> 32;
}

} // namespace

StyleTable::StyleTable(const StyleTable& other) : StyleTable() // from here on the destructor runs
{
    const std::size_t size = other.size(); // `other` may grow meanwhile
    for (std::size_t i = 0; i < size; ++i)
        indexOf(other[StyleIndex(i)]);
}

StyleTable::~StyleTable()
{
    for (const auto& step : steps_)
        delete[] step.load(std::memory_order_relaxed);
}

StyleIndex StyleTable::indexOf(const Style& style)
{
    const std::size_t hash = hashOf(style);
    const std::lock_guard lock(adding_);
    const auto [first, last] = found_.equal_range(hash);
    for (auto at = first; at != last; ++at)
        if (sameStyleBits((*this)[at->second], style))
            return at->second;

    const auto index = StyleIndex(size_.load(std::memory_order_relaxed));
    const Place place = placeOf(index);
    assert(place.step < steps_.size());
    if (place.at == 0 && !steps_[place.step].load(std::memory_order_relaxed))
        steps_[place.step].store(new Style[firstStep << place.step], std::memory_order_release);
    steps_[place.step].load(std::memory_order_relaxed)[place.at] = style;
    found_.emplace(hash, index);
    size_.store(std::size_t(index) + 1, std::memory_order_release);
    return index;
}

StyleEntry StyleTable::entry(StyleIndex index) const
{
    assert(index < size());
    return {*this, index};
}

const Style& StyleTable::operator[](StyleIndex index) const
{
    assert(index < size());
    const Place place = placeOf(index);
    return steps_[place.step].load(std::memory_order_acquire)[place.at];
}

} // namespace app
