// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstdint>
#include <span>

namespace app {

/// The splitmix64 mixing function: each bit of the result depends on each bit of `x`.
constexpr std::uint64_t mixed(std::uint64_t x)
{
    x += 0x9e3779b97f4a7c15;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
    x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
    return x ^ (x >> 31);
}
inline std::uint64_t mixed(double x) { return mixed(std::bit_cast<std::uint64_t>(x)); }

/// A fast checksum of pixels (FNV). It depends on their order.
constexpr std::uint64_t checksumOf(std::span<const std::uint32_t> pixels)
{
    std::uint64_t sum = 0;
    for (const std::uint32_t pixel : pixels)
        sum = (sum ^ pixel) * 0x100000001b3;
    return mixed(sum);
}

} // namespace app
