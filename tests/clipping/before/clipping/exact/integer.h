// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>

namespace clipping {

/// A signed integer wide enough for every sum of two products of three differences of doubles,
/// divided by one of them, when all doubles are counted in units of their common lowest bit: 2099
/// bits a difference, 4200 such a sum. Lives on the stack and allocates nothing; the cost depends
/// on the bits that are used, not on the capacity.
class ExactInteger {
public:
    ExactInteger() = default;
    /// value / 2^exponent, which must be whole.
    ExactInteger(double value, int exponent);

    int sign() const { return size_ == 0 ? 0 : negative_ ? -1 : 1; }
    int bits() const; ///< of the magnitude; 0 has none
    ExactInteger operator-() const;
    ExactInteger operator<<(int count) const;
    friend ExactInteger operator+(const ExactInteger& a, const ExactInteger& b);
    friend ExactInteger operator-(const ExactInteger& a, const ExactInteger& b) { return a + -b; }
    friend ExactInteger operator*(const ExactInteger& a, const ExactInteger& b);

    /// The quotient of the magnitudes, rounded down, and whether something remained.
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

    static constexpr std::size_t capacity = 136; // 4352 bits: 4200, and room to shift by a word
    std::array<std::uint32_t, capacity>
        words_; // the lowest first; only size_ of them mean anything
    std::size_t size_ = 0;
    bool negative_ = false;
};

/// The exponent of the lowest bit that is set in a finite number that is not 0.
int lowestBit(double value);

} // namespace clipping
