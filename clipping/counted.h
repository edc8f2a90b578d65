// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/geometry.h"

#include <compare>
#include <concepts>

namespace CLEARCUT_API clipping {

/// Numbers of arithmetic operations.
struct OperationCounts {
    std::uint64_t additions = 0;       ///< additions and subtractions
    std::uint64_t multiplications = 0; ///< of two numbers
    std::uint64_t divisions = 0;       ///< of one number by another
    std::uint64_t comparisons = 0;     ///< <, <=, >, >= and equality
    std::uint64_t negations = 0;       ///< sign changes, -x
    /// Whether all five are equal.
    friend bool operator==(const OperationCounts&, const OperationCounts&) = default;
};

/// The calling thread's running total, incremented by every operation on a Counted number.
constinit inline thread_local OperationCounts operations;

/// A number that counts the operations on it. An algorithm run with Counted<double> instead of
/// double gives the same result, bit for bit, and counts its operations.
template <class T>
class Counted {
public:
    Counted() = default;
    constexpr explicit Counted(T value) : value_(value) {} ///< not counted
    constexpr T value() const { return value_; }           ///< the number; not counted

    /// The operator of T; adds one to the calling thread's `operations`.
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
    T value_; // uninitialised on purpose, because GLM stores it in a union
};

/// The value as a double, for traces; not counted.
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

/// The same coordinates as Counted numbers.
template <class T, glm::length_t N>
constexpr glm::vec<N, Counted<T>> counted(const glm::vec<N, T>& p)
{
    glm::vec<N, Counted<T>> q;
    for (glm::length_t k = 0; k < N; ++k)
        q[k] = Counted(p[k]);
    return q;
}
/// The same ends as Counted numbers.
template <class T, glm::length_t N>
constexpr BasicSegment<Counted<T>, N> counted(const BasicSegment<T, N>& s)
{
    return {counted(s.a), counted(s.b)};
}
/// The same edges as Counted numbers.
template <class T, glm::length_t N>
constexpr BasicWindow<Counted<T>, N> counted(const BasicWindow<T, N>& w)
{
    return {counted(w.min), counted(w.max)};
}
/// The same coordinates as plain numbers.
template <class T, glm::length_t N>
constexpr glm::vec<N, T> values(const glm::vec<N, Counted<T>>& p)
{
    glm::vec<N, T> q;
    for (glm::length_t k = 0; k < N; ++k)
        q[k] = p[k].value();
    return q;
}
/// The same ends as plain numbers.
template <class T, glm::length_t N>
constexpr BasicSegment<T, N> plain(const BasicSegment<Counted<T>, N>& s)
{
    return {values(s.a), values(s.b)};
}
/// The same numbers in double, exactly.
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
