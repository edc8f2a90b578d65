// SPDX-License-Identifier: MIT
#include "clipping/exact/integer.h"

#include "clipping/ieee_numbers.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <tuple>

namespace clipping {
namespace {

/// A double as whole * 2^exponent.
struct Parts {
    std::uint64_t whole;
    int exponent;
};

Parts partsOf(double value)
{
    int exponent;
    const double fraction = std::frexp(std::abs(value), &exponent);
    return {static_cast<std::uint64_t>(std::ldexp(fraction, 53)), exponent - 53};
}

} // namespace

int lowestBit(double value)
{
    const auto [whole, exponent] = partsOf(value);
    assert(whole != 0);
    return exponent + std::countr_zero(whole);
}

ExactInteger::ExactInteger(double value, int exponent)
{
    if (value == 0)
        return;
    auto [whole, own] = partsOf(value);
    const int zeros = std::countr_zero(whole);
    whole >>= zeros;
    assert(own + zeros >= exponent);
    words_[0] = static_cast<std::uint32_t>(whole);
    words_[1] = static_cast<std::uint32_t>(whole >> 32);
    size_ = 2;
    negative_ = value < 0;
    trim();
    *this = *this << (own + zeros - exponent);
}

int ExactInteger::bits() const
{
    return size_ == 0 ? 0 : static_cast<int>(32 * size_) - std::countl_zero(words_[size_ - 1]);
}

ExactInteger ExactInteger::operator-() const
{
    ExactInteger result = *this;
    result.negative_ = !negative_;
    return result;
}

ExactInteger ExactInteger::operator<<(int count) const
{
    assert(count >= 0);
    const auto whole = static_cast<std::size_t>(count / 32);
    const int rest = count % 32;
    ExactInteger result;
    result.negative_ = negative_;
    if (size_ == 0)
        return result;
    assert(size_ + whole + 1 <= capacity);
    std::fill_n(result.words_.begin(), whole, 0u);
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < size_; ++i) {
        carry |= static_cast<std::uint64_t>(words_[i]) << rest;
        result.words_[whole + i] = static_cast<std::uint32_t>(carry);
        carry >>= 32;
    }
    result.words_[whole + size_] = static_cast<std::uint32_t>(carry);
    result.size_ = whole + size_ + 1;
    result.trim();
    return result;
}

ExactInteger operator+(const ExactInteger& a, const ExactInteger& b)
{
    if (a.negative_ == b.negative_ || a.size_ == 0 || b.size_ == 0) {
        ExactInteger sum = ExactInteger::addMagnitudes(a, b);
        sum.negative_ = a.size_ == 0 ? b.negative_ : a.negative_;
        return sum;
    }
    const bool larger = std::is_gteq(ExactInteger::compareMagnitudes(a, b));
    ExactInteger difference =
        larger ? ExactInteger::subtractMagnitudes(a, b) : ExactInteger::subtractMagnitudes(b, a);
    difference.negative_ = larger ? a.negative_ : b.negative_;
    return difference;
}

ExactInteger operator*(const ExactInteger& a, const ExactInteger& b)
{
    assert(a.size_ + b.size_ <= ExactInteger::capacity);
    ExactInteger product;
    product.size_ = a.size_ + b.size_;
    product.negative_ = a.negative_ != b.negative_;
    std::fill_n(product.words_.begin(), product.size_, 0u);
    for (std::size_t i = 0; i < a.size_; ++i) {
        std::uint64_t carry = 0;
        for (std::size_t j = 0; j < b.size_; ++j) {
            carry += static_cast<std::uint64_t>(a.words_[i]) * b.words_[j] + product.words_[i + j];
            product.words_[i + j] = static_cast<std::uint32_t>(carry);
            carry >>= 32;
        }
        product.words_[i + b.size_] = static_cast<std::uint32_t>(carry);
    }
    product.trim();
    return product;
}

ExactInteger::Quotient ExactInteger::divide(ExactInteger numerator, const ExactInteger& denominator)
{
    assert(denominator.size_ != 0);
    std::uint64_t whole = 0;
    for (int shift = numerator.bits() - denominator.bits(); shift >= 0; --shift) {
        assert(shift < 64);
        const ExactInteger step = denominator << shift;
        if (std::is_gteq(compareMagnitudes(numerator, step))) {
            numerator = subtractMagnitudes(numerator, step);
            whole |= std::uint64_t{1} << shift;
        }
    }
    return {whole, numerator.size_ != 0};
}

std::strong_ordering ExactInteger::compareMagnitudes(const ExactInteger& a, const ExactInteger& b)
{
    if (a.size_ != b.size_)
        return a.size_ <=> b.size_;
    for (std::size_t i = a.size_; i-- > 0;)
        if (a.words_[i] != b.words_[i])
            return a.words_[i] <=> b.words_[i];
    return std::strong_ordering::equal;
}

ExactInteger ExactInteger::addMagnitudes(const ExactInteger& a, const ExactInteger& b)
{
    const auto& [longer, shorter] = a.size_ >= b.size_ ? std::tie(a, b) : std::tie(b, a);
    ExactInteger sum;
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < longer.size_; ++i) {
        carry += longer.words_[i];
        carry += i < shorter.size_ ? shorter.words_[i] : 0;
        sum.words_[i] = static_cast<std::uint32_t>(carry);
        carry >>= 32;
    }
    assert(longer.size_ < capacity);
    sum.words_[longer.size_] = static_cast<std::uint32_t>(carry);
    sum.size_ = longer.size_ + 1;
    sum.trim();
    return sum;
}

ExactInteger ExactInteger::subtractMagnitudes(const ExactInteger& larger,
                                              const ExactInteger& smaller)
{
    ExactInteger difference;
    std::int64_t borrow = 0;
    for (std::size_t i = 0; i < larger.size_; ++i) {
        borrow += larger.words_[i];
        borrow -= i < smaller.size_ ? smaller.words_[i] : 0;
        difference.words_[i] = static_cast<std::uint32_t>(borrow);
        borrow >>= 32; // arithmetic shift: -1 after a borrow
    }
    difference.size_ = larger.size_;
    difference.trim();
    return difference;
}

void ExactInteger::trim()
{
    while (size_ > 0 && words_[size_ - 1] == 0)
        --size_;
}

} // namespace clipping
