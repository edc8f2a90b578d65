// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/geometry.h"

#include <compare>
#include <concepts>

namespace clipping {

/// How much arithmetic was done.
struct OperationCounts {
    std::uint64_t additions = 0;       ///< and subtractions
    std::uint64_t multiplications = 0; ///< of two numbers
    std::uint64_t divisions = 0;       ///< of one number by another
    std::uint64_t comparisons = 0;     ///< in any order, and for equality
    std::uint64_t negations = 0;       ///< changes of sign
    /// Whether all five are equal.
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
    constexpr explicit Counted(T value) : value_(value) {} ///< costs nothing
    constexpr T value() const { return value_; }           ///< the number, which costs nothing

    /// What the operator does to a T; adds one to the calling thread's `operations`.
    /// @{
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
    /// @}

private:
    T value_; // uninitialised on purpose: GLM keeps it in a union
};

/// The number behind a number: what a trace shows, never counted.
constexpr double plain(double x) { return x; }
template <class T>
constexpr double plain(Counted<T> x)
{
    return static_cast<double>(x.value());
}
template <std::integral T>
constexpr double plain(T x)
{
    return static_cast<double>(x);
}

/// The same coordinates, to be counted from here on.
template <class T, glm::length_t N>
constexpr glm::vec<N, Counted<T>> counted(const glm::vec<N, T>& p)
{
    glm::vec<N, Counted<T>> q;
    for (glm::length_t k = 0; k < N; ++k)
        q[k] = Counted(p[k]);
    return q;
}
/// The same ends, to be counted from here on.
template <class T, glm::length_t N>
constexpr BasicSegment<Counted<T>, N> counted(const BasicSegment<T, N>& s)
{
    return {counted(s.a), counted(s.b)};
}
/// The same edges, to be counted from here on.
template <class T, glm::length_t N>
constexpr BasicWindow<Counted<T>, N> counted(const BasicWindow<T, N>& w)
{
    return {counted(w.min), counted(w.max)};
}
/// The same coordinates, no longer counted.
template <class T, glm::length_t N>
constexpr glm::vec<N, T> values(const glm::vec<N, Counted<T>>& p)
{
    glm::vec<N, T> q;
    for (glm::length_t k = 0; k < N; ++k)
        q[k] = p[k].value();
    return q;
}
/// The same ends, no longer counted.
template <class T, glm::length_t N>
constexpr BasicSegment<T, N> plain(const BasicSegment<Counted<T>, N>& s)
{
    return {values(s.a), values(s.b)};
}
/// Every float is a double.
template <class T, glm::length_t N>
constexpr BasicSegment<double, N> inDouble(const BasicSegment<T, N>& s)
{
    return {glm::vec<N, double>(s.a), glm::vec<N, double>(s.b)};
}
template <class T, glm::length_t N>
constexpr BasicWindow<double, N> inDouble(const BasicWindow<T, N>& w)
{
    return {glm::vec<N, double>(w.min), glm::vec<N, double>(w.max)};
}

} // namespace clipping
