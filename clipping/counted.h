// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/geometry.h"

#include <compare>

namespace clipping {

/// How much arithmetic was done.
struct OperationCounts {
    std::uint64_t additions = 0; ///< and subtractions
    std::uint64_t multiplications = 0;
    std::uint64_t divisions = 0;
    std::uint64_t comparisons = 0;
    std::uint64_t negations = 0;
    friend bool operator==(const OperationCounts&, const OperationCounts&) = default;
};

/// The calling thread's running total: what every Counted number adds to.
constinit inline thread_local OperationCounts operations;

/// A number that counts its own operations. An algorithm run with Counted<double> instead of
/// double gives the same bits, and tells what they cost.
template <class T>
class Counted {
public:
    Counted() = default;
    constexpr explicit Counted(T value) : value_(value) {}
    constexpr T value() const { return value_; }

    friend Counted operator-(Counted x) { return ++operations.negations, Counted(-x.value_); }
    friend Counted operator+(Counted x, Counted y)
    {
        return ++operations.additions, Counted(x.value_ + y.value_);
    }
    friend Counted operator-(Counted x, Counted y)
    {
        return ++operations.additions, Counted(x.value_ - y.value_);
    }
    friend Counted operator*(Counted x, Counted y)
    {
        return ++operations.multiplications, Counted(x.value_ * y.value_);
    }
    friend Counted operator/(Counted x, Counted y)
    {
        return ++operations.divisions, Counted(x.value_ / y.value_);
    }
    friend bool operator==(Counted x, Counted y)
    {
        return ++operations.comparisons, x.value_ == y.value_;
    }
    friend auto operator<=>(Counted x, Counted y)
    {
        return ++operations.comparisons, x.value_ <=> y.value_;
    }
    Counted& operator+=(Counted x) { return *this = *this + x; }
    Counted& operator-=(Counted x) { return *this = *this - x; }
    Counted& operator*=(Counted x) { return *this = *this * x; }
    Counted& operator/=(Counted x) { return *this = *this / x; }

private:
    T value_; // uninitialised on purpose: GLM keeps it in a union
};

/// The number behind a number: what a watcher shows, never counted.
constexpr double plain(double x) { return x; }
template <class T>
constexpr double plain(Counted<T> x)
{
    return static_cast<double>(x.value());
}
constexpr double plain(unsigned x) { return x; }

template <class T>
constexpr BasicSegment<Counted<T>> counted(const BasicSegment<T>& s)
{
    return {{Counted(s.a.x), Counted(s.a.y)}, {Counted(s.b.x), Counted(s.b.y)}};
}
template <class T>
constexpr BasicWindow<Counted<T>> counted(const BasicWindow<T>& w)
{
    return {{Counted(w.min.x), Counted(w.min.y)}, {Counted(w.max.x), Counted(w.max.y)}};
}
template <class T>
constexpr BasicSegment<T> plain(const BasicSegment<Counted<T>>& s)
{
    return {{s.a.x.value(), s.a.y.value()}, {s.b.x.value(), s.b.y.value()}};
}
/// Every float is a double.
template <class T>
constexpr Segment inDouble(const BasicSegment<T>& s)
{
    return {glm::dvec2(s.a), glm::dvec2(s.b)};
}

} // namespace clipping
