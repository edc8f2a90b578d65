// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/algorithm.h"
#include "clipping/ends.h"
#include "clipping/frame.h"
#include "clipping/limits.h"
#include "clipping/numbers.h"

#include <limits>

// Makes the functions of an algorithm for infinite lines and rays from `Method::clip<reach>`
// (algorithms/lines_and_rays/).

namespace clipping {

/// How far the input extends beyond its two points. Bounded: not at all (segment); OneWay: beyond b
/// (ray); BothWays: beyond both (infinite line).
enum class Reach : std::uint8_t { Bounded, OneWay, BothWays };

template <Reach reach>
using LineOrRay = std::conditional_t<reach == Reach::BothWays, Line, Ray>;

/// The parameters where a reach begins and ends, with 0 at a and 1 at b.
template <Reach reach, class T>
constexpr T beginning()
{
    return T(reach == Reach::BothWays ? -std::numeric_limits<double>::infinity() : 0.0);
}
template <Reach reach, class T>
constexpr T ending()
{
    return T(reach == Reach::Bounded ? 1.0 : std::numeric_limits<double>::infinity());
}

/// Whether the contract covers this input.
inline bool isLineOrRay(const Segment& points, const Window& w)
{
    return legal(points) && legal(w) && points.a != points.b;
}

/// Runs a method on valid input, with double or, where double would overflow or underflow, with
/// Wide.
template <class Method, Reach reach>
std::optional<Segment> clipLineOrRay(const Segment& points, const Window& w)
{
    const auto run = [&]<class T>(T) -> std::optional<Segment> {
        const auto piece =
            Method::template clip<reach>(segmentIn<T>(points), windowIn<T>(w), Unwatched{});
        return piece ? std::optional(inDouble(*piece)) : std::nullopt;
    };
    return ordinary(points) && ordinary(w) ? run(double{}) : run(Wide{});
}
template <class Method, Reach reach>
std::optional<Segment> clipLineOrRayCounted(const Segment& points, const Window& w, auto& step)
{
    const auto run = [&]<class T>(T) -> std::optional<Segment> {
        const auto piece = Method::template clip<reach>(segmentIn<Counted<T>>(points),
                                                        windowIn<Counted<T>>(w), step);
        return piece ? std::optional(inDouble(plain(*piece))) : std::nullopt;
    };
    return ordinary(points) && ordinary(w) ? run(double{}) : run(Wide{});
}

/// Makes both ends equal at a window without height or width, which is met in one point that may be
/// rounded differently at each end.
inline std::optional<Segment> contacted(std::optional<Segment> piece, const Segment& points,
                                        const Window& w)
{
    if (piece && meetsInAPoint(points, w))
        piece->b = piece->a;
    return piece;
}

template <class Method, Reach reach>
std::optional<Segment> clipOneLineOrRay(const LineOrRay<reach>& lineOrRay, const Window& w)
{
    const Segment points{lineOrRay.a, lineOrRay.b};
    if (!isLineOrRay(points, w))
        return std::nullopt;
    return contacted(clipLineOrRay<Method, reach>(points, w), points, w);
}

template <class Method, Reach reach>
std::size_t clipManyLinesOrRays(std::span<const LineOrRay<reach>> in, const Window& w,
                                std::span<Clipped> out)
{
    requireRoom(in.size(), out.size());
    std::size_t visible = 0;
    for (std::size_t i = 0; i < in.size(); ++i)
        if (const auto piece = clipOneLineOrRay<Method, reach>(in[i], w)) {
            const bool cutA = reach == Reach::BothWays || piece->a != in[i].a;
            out[visible++] = {
                *piece, static_cast<std::uint32_t>(i),
                cutAt(cutA ? edgeAt(piece->a, w) : Edge::NoEdge, edgeAt(piece->b, w))};
        }
    return visible;
}

template <class Method, Reach reach>
OperationCounts countManyLinesOrRays(std::span<const LineOrRay<reach>> in, const Window& w)
{
    operations = {};
    Unwatched step;
    for (const auto& [a, b] : in)
        if (isLineOrRay({a, b}, w))
            clipLineOrRayCounted<Method, reach>({a, b}, w, step);
    return operations;
}

template <class Method, Reach reach>
Trace traceOneLineOrRay(const LineOrRay<reach>& lineOrRay, const Window& w)
{
    const Segment points{lineOrRay.a, lineOrRay.b};
    if (!isLineOrRay(points, w))
        return {};
    operations = {};
    Recorder recorder;
    recorder.begin(points, w);
    const auto piece =
        contacted(clipLineOrRayCounted<Method, reach>(points, w, recorder), points, w);
    Trace trace = recorder.take();
    if (piece) {
        trace.outcome = Outcome::Visible;
        trace.visible = *piece;
    }
    return trace;
}

template <class Method, Reach reach>
constexpr Functions<LineOrRay<reach>, Window, Segment> lineOrRayUses{
    clipOneLineOrRay<Method, reach>, clipManyLinesOrRays<Method, reach>,
    countManyLinesOrRays<Method, reach>, traceOneLineOrRay<Method, reach>};

/// The form for infinite lines or rays; none unless the row names one (algorithms/lines_and_rays/).
template <class Method, Reach reach>
constexpr const Functions<LineOrRay<reach>, Window, Segment>* lineOrRayUsesOf()
{
    if constexpr (requires { Method::line; }) {
        if constexpr (reach == Reach::BothWays)
            return Method::line;
        else
            return Method::ray;
    } else
        return nullptr;
}

} // namespace clipping
