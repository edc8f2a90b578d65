// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/convex_window.h"
#include "clipping/output.h"
#include "clipping/segments_view.h"
#include "clipping/visible_runs.h"

#include <optional>
#include <string_view>
#include <vector>

// For programs that only clip and do not compare algorithms. Each function uses the best row of the
// catalogue (`algorithmFor`), whose contract (algorithm.h) holds. No container of the
// standard library passes between a program and the compiled library. A program that takes numbers
// near 0 for 0 (linked with -ffast-math) gets the same results here.

namespace CLEARCUT_API clipping {

/// The key of the catalogue's row that clips a Shape at a window or a box, or At something else:
/// "exact" makes no wrong decision and rounds each new coordinate once. Lines, rays, and segments
/// in three dimensions are clipped at windows and boxes by the row that is best there. Lines and
/// rays at polygons, for which no row has a form, are clipped as `exact` clips segments.
template <class Shape, class At = Window>
inline constexpr std::string_view algorithmFor = "exact";
template <class T, class U>
inline constexpr std::string_view algorithmFor<BasicLine<T>, BasicWindow<U>> = "liang-barsky";
template <class T, class U>
inline constexpr std::string_view algorithmFor<BasicRay<T>, BasicWindow<U>> = "liang-barsky";
template <class T, class At>
inline constexpr std::string_view algorithmFor<BasicSegment<T, 3>, At> = "liang-barsky";

/// The part of a segment, line, ray or polyline inside a window, a convex polygon or a box: nothing
/// if there is none. Floats are clipped at a polygon, and as lines and rays, in double; then each
/// new coordinate is rounded to float.
/// @{
std::optional<Segment> clip(const Segment& segment, const Window& window) noexcept;
std::optional<BasicSegment<float>> clip(const BasicSegment<float>& segment,
                                        const BasicWindow<float>& window) noexcept;
std::optional<Segment> clip(const Segment& segment, const ConvexWindow& window) noexcept;
std::optional<BasicSegment<float>> clip(const BasicSegment<float>& segment,
                                        const ConvexWindow& window) noexcept;
std::optional<Segment> clip(const Line& line, const Window& window) noexcept;
std::optional<BasicSegment<float>> clip(const BasicLine<float>& line,
                                        const BasicWindow<float>& window) noexcept;
std::optional<Segment> clip(const Ray& ray, const Window& window) noexcept;
std::optional<BasicSegment<float>> clip(const BasicRay<float>& ray,
                                        const BasicWindow<float>& window) noexcept;
std::optional<Segment> clip(const Line& line, const ConvexWindow& window) noexcept;
std::optional<BasicSegment<float>> clip(const BasicLine<float>& line,
                                        const ConvexWindow& window) noexcept;
std::optional<Segment> clip(const Ray& ray, const ConvexWindow& window) noexcept;
std::optional<BasicSegment<float>> clip(const BasicRay<float>& ray,
                                        const ConvexWindow& window) noexcept;
std::optional<Segment3> clip(const Segment3& segment, const Window3& box) noexcept;
inline VisibleRuns clip(const Polyline& polyline, const Window& window)
{
    return {polyline, window};
}
inline BasicVisibleRuns<float> clip(const BasicPolyline<float>& polyline,
                                    const BasicWindow<float>& window)
{
    return {polyline, window};
}
/// @}

/// The part of the segment from a to b, which are points of any type (point.h).
template <PointLike P, class Window>
auto clip(const P& a, const P& b, const Window& window) noexcept
{
    return clip(segmentOf(a, b), window);
}

/// Clips many into memory of the caller (output.h), in input order, and says how far it got: writes
/// nothing beyond the output's end. Allocates nothing. Views of segments that are not one array are
/// read in blocks.
/// @{
Progress clipAll(const SegmentsView<double>& in, const Window& window, Output<double> out) noexcept;
Progress clipAll(const SegmentsView<float>& in, const BasicWindow<float>& window,
                 Output<float> out) noexcept;
Progress clipAll(const SegmentsView<double>& in, const ConvexWindow& window,
                 Output<double> out) noexcept;
Progress clipAll(const SegmentsView<float>& in, const ConvexWindow& window,
                 Output<float> out) noexcept;
Progress clipAll(const LinesView<double>& in, const Window& window, Output<double> out) noexcept;
Progress clipAll(const LinesView<float>& in, const BasicWindow<float>& window,
                 Output<float> out) noexcept;
Progress clipAll(const RaysView<double>& in, const Window& window, Output<double> out) noexcept;
Progress clipAll(const RaysView<float>& in, const BasicWindow<float>& window,
                 Output<float> out) noexcept;
Progress clipAll(const LinesView<double>& in, const ConvexWindow& window,
                 Output<double> out) noexcept;
Progress clipAll(const LinesView<float>& in, const ConvexWindow& window,
                 Output<float> out) noexcept;
Progress clipAll(const RaysView<double>& in, const ConvexWindow& window,
                 Output<double> out) noexcept;
Progress clipAll(const RaysView<float>& in, const ConvexWindow& window, Output<float> out) noexcept;
Progress clipAll(std::span<const Segment3> in, const Window3& box,
                 std::span<BasicClipped<Segment3>> out) noexcept;
/// @}

/// The visible pieces of fewer than 2^32 segments, lines or rays.
/// @{
template <class T, class Window>
std::vector<BasicClipped<BasicSegment<T>>> clipAll(const SegmentsView<T>& in, const Window& window)
{
    std::vector<BasicClipped<BasicSegment<T>>> pieces(in.size());
    pieces.resize(clipAll(in, window, Output<T>(pieces)).visible);
    return pieces;
}
template <template <class> class LineOrRay, class T, class Window>
std::vector<BasicClipped<BasicSegment<T>>> clipAll(const LinesOrRaysView<LineOrRay, T>& in,
                                                   const Window& window)
{
    std::vector<BasicClipped<BasicSegment<T>>> pieces(in.size());
    pieces.resize(clipAll(in, window, Output<T>(pieces)).visible);
    return pieces;
}
template <std::ranges::contiguous_range Array, class Window>
auto clipAll(const Array& in, const Window& window)
{
    using Shape = std::ranges::range_value_t<Array>;
    using T = decltype(Shape::a.x);
    if constexpr (std::same_as<Shape, BasicLine<T>>)
        return clipAll(LinesView<T>(in), window);
    else if constexpr (std::same_as<Shape, BasicRay<T>>)
        return clipAll(RaysView<T>(in), window);
    else
        return clipAll(SegmentsView<T>(in), window);
}
/// @}

} // namespace clipping
