// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/algorithm.h"
#include "clipping/frame.h"
#include "clipping/limits.h"
#include "clipping/polygon/meet.h"
#include "clipping/polygon/uses.h"

// Makes the functions of an algorithm for convex polygons from one template, `Method::clip`. Only
// the .cpp files of this folder include it.

namespace clipping {

/// Runs a method, or clipFlat for a polygon without area, with any number type.
template <class Method, class T, class Step>
std::optional<PolygonPiece<T>> clipIn(const BasicSegment<T>& s, const PreparedPolygon& polygon,
                                      Step&& step)
{
    const PolygonIn<T> in(polygon);
    return polygon.flat ? clipFlat<Method>(s, in, step) : Method::clip(s, in, step);
}

/// Whether double suffices; if not, the same algorithm runs with Wide. A method with `unframed`
/// handles all numbers itself.
template <class Method>
bool easy(const Segment& s, const PreparedPolygon& polygon)
{
    if constexpr (requires { Method::unframed; })
        return true;
    else
        return polygon.ordinary && ordinary(s);
}

/// Sets the edge number to 0 at each end that equals the same end of the input.
inline PolygonPiece<double> named(PolygonPiece<double> piece, const Segment& whole)
{
    if (piece.segment.a == whole.a)
        piece.numberOfA = 0;
    if (piece.segment.b == whole.b)
        piece.numberOfB = 0;
    return piece;
}

template <class Method>
std::optional<PolygonPiece<double>> clipPrepared(const Segment& s, const PreparedPolygon& polygon)
{
    if (!legal(s))
        return std::nullopt;
    if (easy<Method>(s, polygon)) [[likely]] {
        const auto piece = clipIn<Method>(s, polygon, Unwatched{});
        return piece ? std::optional(polygon.namesEveryCut ? *piece : named(*piece, s))
                     : std::nullopt;
    }
    if constexpr (!requires { Method::unframed; })
        if (const auto piece = clipIn<Method>(segmentIn<Wide>(s), polygon, Unwatched{}))
            return named({inDouble(piece->segment), piece->numberOfA, piece->numberOfB}, s);
    return std::nullopt;
}

template <class Method>
std::optional<Segment> clipOneInPolygon(const Segment& segment, const ConvexPolygon& polygon)
{
    const auto window = prepared(polygon);
    if (!window)
        return std::nullopt;
    const auto piece = clipPrepared<Method>(segment, *window);
    return piece ? std::optional(piece->segment) : std::nullopt;
}

template <class Method>
std::size_t clipManyInPolygon(std::span<const Segment> in, const ConvexPolygon& polygon,
                              std::span<Clipped> out)
{
    requireRoom(in.size(), out.size());
    const auto window = prepared(polygon);
    std::size_t visible = 0;
    for (std::size_t i = 0; window && i < in.size(); ++i)
        if (const auto piece = clipPrepared<Method>(in[i], *window))
            out[visible++] = {piece->segment, static_cast<std::uint32_t>(i),
                              polygonCutAt(piece->numberOfA, piece->numberOfB)};
    return visible;
}

/// Runs one segment with Counted numbers and a step reporter; the visible piece is returned in
/// double.
template <class Method, class Step>
std::optional<Segment> clipCounted(const Segment& s, const PreparedPolygon& polygon, Step& step)
{
    const auto run = [&]<class T>(T) -> std::optional<Segment> {
        const auto piece = clipIn<Method>(segmentIn<Counted<T>>(s), polygon, step);
        return piece ? std::optional(inDouble(plain(piece->segment))) : std::nullopt;
    };
    if constexpr (!requires { Method::unframed; })
        if (!easy<Method>(s, polygon))
            return run(Wide{});
    return run(double{});
}

template <class Method>
OperationCounts countManyInPolygon(std::span<const Segment> in, const ConvexPolygon& polygon)
{
    const auto window = prepared(polygon);
    operations = {};
    Unwatched step;
    for (const Segment& s : in)
        if (window && legal(s))
            clipCounted<Method>(s, *window, step);
    return operations;
}

template <class Method>
Trace traceOneInPolygon(const Segment& segment, const ConvexPolygon& polygon)
{
    const auto window = prepared(polygon);
    if (!window || !legal(segment))
        return {};
    operations = {};
    Recorder recorder;
    recorder.begin(segment, window->box);
    const auto piece = clipCounted<Method>(segment, *window, recorder);
    Trace trace = recorder.take();
    if (piece) {
        trace.outcome = Outcome::Visible;
        trace.visible = *piece;
    }
    return trace;
}

/// Clips many segments. A method may have its own function for this: `Method::many`.
template <class Method>
constexpr auto manyInPolygon()
{
    if constexpr (requires { Method::many; })
        return Method::many;
    else
        return clipManyInPolygon<Method>;
}

template <class Method>
constexpr Functions<Segment, ConvexPolygon> polygonUses{
    clipOneInPolygon<Method>, manyInPolygon<Method>(), countManyInPolygon<Method>,
    traceOneInPolygon<Method>};

} // namespace clipping
