// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <compare>

namespace clipping {

/// A double with an exponent range that products of differences of doubles cannot exceed.
/// Algorithms run with it where double would overflow or lose digits to underflow. Rounds like
/// double. Infinity may be used in comparisons only.
class Wide {
public:
    Wide() = default;
    Wide(double value) { *this = of(value, 0); } // every double is a Wide
    explicit operator double() const { return std::ldexp(fraction_, exponent_); }

    friend Wide operator-(Wide x)
    {
        x.fraction_ = -x.fraction_;
        return x;
    }
    friend Wide operator+(Wide x, Wide y)
    {
        if (x.fraction_ == 0 || (y.fraction_ != 0 && x.exponent_ < y.exponent_))
            return y.fraction_ == 0 ? y : y + x;
        return of(x.fraction_ + std::ldexp(y.fraction_, y.exponent_ - x.exponent_), x.exponent_);
    }
    friend Wide operator-(Wide x, Wide y) { return x + -y; }
    friend Wide operator*(Wide x, Wide y)
    {
        return of(x.fraction_ * y.fraction_, x.exponent_ + y.exponent_);
    }
    friend Wide operator/(Wide x, Wide y)
    {
        return of(x.fraction_ / y.fraction_, x.exponent_ - y.exponent_);
    }
    friend bool operator==(Wide x, Wide y) { return (x - y).fraction_ == 0; }
    friend auto operator<=>(Wide x, Wide y) { return (x - y).fraction_ <=> 0.0; }

private:
    static Wide of(double fraction, int exponent)
    {
        Wide result;
        result.fraction_ = fraction, result.exponent_ = 0;
        if (fraction == 0 || !std::isfinite(fraction)) // frexp does not define infinity's exponent
            return result;
        int shift;
        result.fraction_ = std::frexp(fraction, &shift);
        result.exponent_ = exponent + shift;
        return result;
    }
    double fraction_; // uninitialised on purpose, because GLM stores it in a union
    int exponent_;
};

inline double plain(Wide x) { return double(x); }

} // namespace clipping
