// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>

namespace clipping {

/// A signed integer wide enough for every sum of two products of three differences of doubles, with
/// all doubles in units of their common lowest bit: 2099 bits for a difference, 6300 for such a sum
/// of products of a difference and a determinant of four. Allocates nothing; the cost depends on
/// the bits in use, not on the capacity.
class ExactInteger {
public:
    ExactInteger() = default;
    /// value / 2^exponent, which must be an integer.
    ExactInteger(double value, int exponent);

    int sign() const { return size_ == 0 ? 0 : negative_ ? -1 : 1; }
    int bits() const; ///< number of bits of the magnitude; 0 for the value 0
    ExactInteger operator-() const;
    ExactInteger operator<<(int count) const;
    friend ExactInteger operator+(const ExactInteger& a, const ExactInteger& b);
    friend ExactInteger operator-(const ExactInteger& a, const ExactInteger& b) { return a + -b; }
    friend ExactInteger operator*(const ExactInteger& a, const ExactInteger& b);

    /// The quotient of the magnitudes, rounded down, and whether there is a remainder.
    struct Quotient {
        std::uint64_t whole;
        bool remainder;
    };
    /// |numerator| / |denominator|, which must be less than 2^63.
    static Quotient divide(ExactInteger numerator, const ExactInteger& denominator);

private:
    static std::strong_ordering compareMagnitudes(const ExactInteger& a, const ExactInteger& b);
    static ExactInteger addMagnitudes(const ExactInteger& a, const ExactInteger& b);
    static ExactInteger subtractMagnitudes(const ExactInteger& larger, const ExactInteger& smaller);
    void trim();

    static constexpr std::size_t capacity = 200; // 6400 bits: 6300, plus room to shift by a word
    std::array<std::uint32_t, capacity>
        words_; // lowest first; only the first size_ words are in use
    std::size_t size_ = 0;
    bool negative_ = false;
};

/// The exponent of the lowest set bit of a finite number other than 0.
int lowestBit(double value);

} // namespace clipping
