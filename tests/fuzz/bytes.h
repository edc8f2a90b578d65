// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

/// Reads a fuzzer's bytes as numbers, such that a few changed bytes lead to the hard cases: the
/// same number twice, one a few ulps away, on a grid, huge, tiny, or none. Behind the end it reads
/// 0.
class Bytes {
public:
    Bytes(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}

    bool ended() const { return left_ == 0; }

    std::uint8_t byte()
    {
        if (left_ == 0)
            return 0;
        --left_;
        return *data_++;
    }
    int small() { return static_cast<std::int8_t>(byte()); }

    /// One byte says how the number is written, the next ones say which it is.
    double number()
    {
        const double x = next(byte() % ways);
        known_.push_back(x);
        return x;
    }

private:
    static constexpr int ways = 7;

    double next(int way)
    {
        switch (way) { // a format of bytes, not a catalogue
        case 0:
            return small();
        case 1:
            return small() / 8.0;
        case 2:
            return earlier();
        case 3:
            return nudged(earlier(), small());
        case 4:
            return (earlier() + earlier()) / 2;
        case 5:
            return std::ldexp(small(), 8 * small());
        default:
            return raw();
        }
    }
    double earlier() { return known_.empty() ? 0 : known_[byte() % known_.size()]; }
    double raw()
    {
        std::uint8_t bytes[sizeof(double)];
        for (std::uint8_t& b : bytes)
            b = byte();
        double x;
        std::memcpy(&x, bytes, sizeof x);
        return x;
    }
    static double nudged(double x, int ulps)
    {
        const double infinity = std::numeric_limits<double>::infinity();
        for (int i = 0; i < std::abs(ulps); ++i)
            x = std::nextafter(x, ulps < 0 ? -infinity : infinity);
        return x;
    }

    const std::uint8_t* data_;
    std::size_t left_;
    std::vector<double> known_;
};
