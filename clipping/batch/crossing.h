// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/batch/lanes.h"
#include "clipping/exact/bounds.h"

// `crossing` of exact/line.h in every lane, on segments that run right and up.

namespace clipping {
namespace {

/// A number and its rounding error, in every lane.
template <class V>
struct VectorPair {
    V high, low;
};

/// The rounding error of the computed difference of a and b.
template <class V>
CLIPPING_INLINE V lowOfDifference(V a, V b, V difference)
{
    const V ofB = difference - a;
    return (a - (difference - ofB)) - (b + ofB);
}

/// The extents of segments on each axis, and their reciprocals.
template <class V>
struct Extent {
    VectorPair<V> x, y;
    V inverseX, inverseY;
};

/// A new coordinate, and the lanes in which it is proved to be the exact value, correctly rounded.
template <class V>
struct Crossing {
    V value;
    typename V::Mask settled;
};

/// start + rise * run / length; all of rise, run and length are >= 0 in lanes that matter.
template <class V>
struct Slope {
    V start;
    VectorPair<V> rise, run, length;
    V inverse; ///< reciprocal of the length
};

/// The number to which both bounds round, in lanes where they round alike.
template <class T, class V>
CLIPPING_INLINE Crossing<V> between(V low, V high)
{
    const V below = low.template rounded<T>(), above = high.template rounded<T>();
    return {below, below == above};
}

/// The crossing without the rounding errors of the differences; sufficient for most floats.
template <class V>
CLIPPING_INLINE Crossing<V> roughCrossing(const Slope<V>& s)
{
    const V q = s.rise.high * s.run.high * s.inverse, sum = s.start + q;
    const V error = V::of(singleBound) * (q + abs(sum));
    return between<float>(sum - error, sum + error);
}

template <class T, class V>
CLIPPING_INLINE Crossing<V> fineCrossing(const Slope<V>& slope)
{
    const auto& [start, rise, run, length, inverse] = slope;
    const V p = rise.high * run.high;
    const V low =
        fma(rise.low, run.high, fma(rise.high, run.low, restOfProduct(rise.high, run.high, p)));
    const V q = p * inverse;
    const V rest = fnma(q, length.low, low - restOfProduct(q, length.high, p));
    const V s = start + q, ofQ = s - start;
    const V t = fma(rest, inverse, (start - (s - ofQ)) + (q - ofQ));
    const V error = fma(V::of(quotientBound), q, V::of(sumBound<T>) * abs(s));
    const auto [value, settled] = between<T>(s + (t - error), s + (t + error));
    // Only underflow must be tested: overflow ends as NaN, which equals nothing.
    const auto tame =
        ((p >= V::of(smallestProduct)) & (q >= V::of(smallestQuotient))) | (rise.high == V::of(0));
    return {value, tame & settled};
}

/// The precision with which crossings are computed. Most floats need little; unsettled ones are
/// computed again with more.
enum class Care : std::uint8_t { Floats, UnsettledFloats, Doubles };
template <class T>
constexpr Care usualCare = sizeof(T) == sizeof(float) ? Care::Floats : Care::Doubles;
template <class T>
constexpr Care mostCare = sizeof(T) == sizeof(float) ? Care::UnsettledFloats : Care::Doubles;

template <Care care, class V>
CLIPPING_INLINE Crossing<V> crossing(const Slope<V>& slope)
{
    if constexpr (care == Care::Floats)
        return roughCrossing(slope);
    else if constexpr (care == Care::UnsettledFloats)
        return fineCrossing<float>(slope);
    else
        return fineCrossing<double>(slope);
}

/// In lanes `byX`: the y at which the lines through (ax, ay) pass the edge of x. In the other
/// lanes: the x at which they pass the edge of y.
template <Care care, class V>
// NOLINTNEXTLINE(readability-function-size): two coordinates for each of two points, in registers
CLIPPING_INLINE Crossing<V> crossing(const Extent<V>& d, typename V::Mask byX, V ax, V ay, V edgeX,
                                     V edgeY)
{
    const V edge = select(byX, edgeX, edgeY), from = select(byX, ax, ay), run = edge - from;
    return crossing<care>(Slope<V>{select(byX, ay, ax),
                                   {select(byX, d.y.high, d.x.high), select(byX, d.y.low, d.x.low)},
                                   {run, lowOfDifference(edge, from, run)},
                                   {select(byX, d.x.high, d.y.high), select(byX, d.x.low, d.y.low)},
                                   select(byX, d.inverseX, d.inverseY)});
}

} // namespace
} // namespace clipping
