// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/point.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <ranges>

namespace CLEARCUT_API clipping {

/// Segments that lie in the caller's memory, in any regular order, without a copy: an array of
/// segments, arrays of coordinates (`columns`), an array of structures (`structs`), or numbers at a
/// distance (`rows`). The memory must outlive the view.
template <class T>
class SegmentsView {
public:
    constexpr SegmentsView() = default;

    /// An array of segments: a vector, an array, a span.
    template <std::ranges::contiguous_range Segments>
    requires std::same_as<std::ranges::range_value_t<Segments>, BasicSegment<T>>
    constexpr SegmentsView(const Segments& segments) noexcept // NOLINT: it is meant to convert
        : SegmentsView(std::ranges::data(segments), std::ranges::size(segments))
    {
    }
    /// The same by the first segment and their number.
    constexpr SegmentsView(const BasicSegment<T>* first, std::size_t count) noexcept
        : count_(count), stride_(sizeof(BasicSegment<T>))
    {
        if (count > 0)
            ax_ = &first->a.x, ay_ = &first->a.y, bx_ = &first->b.x, by_ = &first->b.y;
    }

    /// The four numbers of the first segment, and the bytes from each segment to the next: a
    /// multiple of alignof(T), which may be 0 or negative.
    // NOLINTNEXTLINE(readability-function-size): four numbers make a segment
    constexpr SegmentsView(const T* ax, const T* ay, const T* bx, const T* by, std::size_t count,
                           std::ptrdiff_t stride) noexcept
        : ax_(ax), ay_(ay), bx_(bx), by_(by), count_(count), stride_(stride)
    {
    }

    constexpr std::size_t size() const noexcept { return count_; } ///< number of segments
    /// A copy of segment i.
    BasicSegment<T> operator[](std::size_t i) const noexcept
    {
        return {{at(ax_, i), at(ay_, i)}, {at(bx_, i), at(by_, i)}};
    }

    /// The segments from `first` on; none if there are not so many.
    SegmentsView from(std::size_t first) const noexcept
    {
        if (first >= count_)
            return {};
        return {&at(ax_, first), &at(ay_, first), &at(bx_, first),
                &at(by_, first), count_ - first,  stride_};
    }

    /// The segments as an array, if they are one; else null.
    const BasicSegment<T>* array() const noexcept
    {
        const bool dense = ax_ && stride_ == std::ptrdiff_t(sizeof(BasicSegment<T>))
                           && ay_ == ax_ + 1 && bx_ == ax_ + 2 && by_ == ax_ + 3;
        return dense ? reinterpret_cast<const BasicSegment<T>*>(ax_) : nullptr;
    }

private:
    const T& at(const T* first, std::size_t i) const noexcept
    {
        return *reinterpret_cast<const T*>(reinterpret_cast<const char*>(first)
                                           + static_cast<std::ptrdiff_t>(i) * stride_);
    }
    const T *ax_ = nullptr, *ay_ = nullptr, *bx_ = nullptr, *by_ = nullptr;
    std::size_t count_ = 0;
    std::ptrdiff_t stride_ = 0;
};

/// Segments whose numbers are in four arrays: a structure of arrays. As many as the shortest holds.
template <std::ranges::contiguous_range Numbers>
// NOLINTNEXTLINE(readability-function-size): four numbers make a segment
constexpr auto columns(const Numbers& ax, const Numbers& ay, const Numbers& bx,
                       const Numbers& by) noexcept
{
    using T = std::ranges::range_value_t<Numbers>;
    const std::size_t count = std::min({std::ranges::size(ax), std::ranges::size(ay),
                                        std::ranges::size(bx), std::ranges::size(by)});
    return SegmentsView<T>(std::ranges::data(ax), std::ranges::data(ay), std::ranges::data(bx),
                           std::ranges::data(by), count, sizeof(T));
}

/// Segments in an array of structures, by the two members that hold their ends. These may be points
/// of any type with members x and y, or [0] and [1], of float or double.
template <std::ranges::contiguous_range Structs, class S, PointLike P>
constexpr auto structs(const Structs& all, P S::*a, P S::*b) noexcept
{
    const auto address = []<int axis>(const P& p, std::integral_constant<int, axis>) {
        if constexpr (requires { std::addressof(p.x); })
            return axis == 0 ? std::addressof(p.x) : std::addressof(p.y);
        else
            return std::addressof(p[axis]);
    };
    constexpr std::integral_constant<int, 0> x;
    constexpr std::integral_constant<int, 1> y;
    using View = SegmentsView<NumberOf<P>>;
    const S* const first = std::ranges::data(all);
    const std::size_t count = std::ranges::size(all);
    return count == 0 ? View()
                      : View(address(first->*a, x), address(first->*a, y), address(first->*b, x),
                             address(first->*b, y), count, sizeof(S));
}

/// Segments of four numbers in a row, x and y of a, then of b, and `stride` bytes from each row to
/// the next.
template <class T>
constexpr SegmentsView<T> rows(const T* numbers, std::size_t count,
                               std::ptrdiff_t stride = 4 * sizeof(T)) noexcept
{
    if (count == 0)
        return {};
    return {numbers, numbers + 1, numbers + 2, numbers + 3, count, stride};
}

/// Lines or rays in the caller's memory: an array of them, or the two points of each in any regular
/// order (`asLines`, `asRays`).
template <template <class> class LineOrRay, class T>
class LinesOrRaysView {
public:
    constexpr LinesOrRaysView() = default;
    /// An array of lines or rays: a vector, an array, a span.
    template <std::ranges::contiguous_range Array>
    requires std::same_as<std::ranges::range_value_t<Array>, LineOrRay<T>>
    constexpr LinesOrRaysView(const Array& array) noexcept // NOLINT: it is meant to convert
        : points_(structs(array, &LineOrRay<T>::a, &LineOrRay<T>::b))
    {
    }
    /// One through the two ends of each segment.
    explicit constexpr LinesOrRaysView(const SegmentsView<T>& points) noexcept : points_(points) {}

    constexpr std::size_t size() const noexcept { return points_.size(); } ///< their number
    /// A copy of line or ray i.
    LineOrRay<T> operator[](std::size_t i) const noexcept
    {
        const BasicSegment<T> points = points_[i];
        return {points.a, points.b};
    }
    /// Those from `first` on; none if there are not so many.
    LinesOrRaysView from(std::size_t first) const noexcept
    {
        return LinesOrRaysView(points_.from(first));
    }

private:
    SegmentsView<T> points_;
};
template <class T>
using LinesView = LinesOrRaysView<BasicLine, T>;
template <class T>
using RaysView = LinesOrRaysView<BasicRay, T>;

/// Lines through the ends of segments, and rays from their a through their b.
/// @{
template <class T>
constexpr LinesView<T> asLines(const SegmentsView<T>& points) noexcept
{
    return LinesView<T>(points);
}
template <class T>
constexpr RaysView<T> asRays(const SegmentsView<T>& points) noexcept
{
    return RaysView<T>(points);
}
/// @}

} // namespace clipping
