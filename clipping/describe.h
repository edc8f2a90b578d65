// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/algorithm.h"

#include <cassert>
#include <cmath>

// How one template, `Method::clip<form>`, becomes the uses of an algorithm. Only the files in
// algorithms/ include this; each ends with `template Algorithm describe<ItsOwnName>();`.

namespace clipping {

/// What a row says of itself, at the top of its file.
struct About {
    std::string_view key, abbreviation, name;
    int year;
    std::string_view idea;
    double ulps;
};

/// k of the contract. Derived in clipping/README.md for all rows at once.
inline constexpr double maxUlps = 16;

/// Whether the contract promises anything for this input: all finite, and min <= max.
constexpr bool withinContract(const Segment& s, const Window& w)
{
    const double zero = (s.a.x - s.a.x) + (s.a.y - s.a.y) + (s.b.x - s.b.x) + (s.b.y - s.b.y)
                        + (w.min.x - w.min.x) + (w.min.y - w.min.y) + (w.max.x - w.max.x)
                        + (w.max.y - w.max.y);
    return zero == 0.0 && w.min.x <= w.max.x && w.min.y <= w.max.y;
}

/// The edge of the window on which a new end lies.
constexpr Edge edgeAt(const glm::dvec2& p, const Window& w)
{
    return p.x == w.min.x   ? Edge::Left
           : p.x == w.max.x ? Edge::Right
           : p.y == w.min.y ? Edge::Bottom
           : p.y == w.max.y ? Edge::Top
                            : Edge::None;
}

/// Which ends of `piece` are not those of `whole`, and on which edges they lie.
constexpr std::uint32_t cutOf(const Segment& whole, const Segment& piece, const Window& w)
{
    return cutAt(piece.a == whole.a ? Edge::None : edgeAt(piece.a, w),
                 piece.b == whole.b ? Edge::None : edgeAt(piece.b, w));
}

template <class Method, Form form>
std::optional<Segment> clipOne(const Segment& segment, const Window& window)
{
    if constexpr (form == Form::Corrected)
        if (!withinContract(segment, window))
            return std::nullopt;
    return Method::template clip<form>(segment, window, Unwatched{});
}

template <class Method, Form form>
[[gnu::flatten]] // the loop must contain the algorithm, not call it
std::size_t
clipMany(std::span<const Segment> in, const Window& window, std::span<Clipped> out)
{
    assert(out.size() >= in.size());
    std::size_t visible = 0;
    for (std::size_t i = 0; i < in.size(); ++i)
        if (const auto piece = clipOne<Method, form>(in[i], window))
            out[visible++] = {*piece, static_cast<std::uint32_t>(i), cutOf(in[i], *piece, window)};
    return visible;
}

template <class Method, Form form>
OperationCounts countMany(std::span<const Segment> in, const Window& window)
{
    operations = {};
    for (const Segment& segment : in)
        if (form == Form::Published || withinContract(segment, window))
            Method::template clip<form>(counted(segment), counted(window), Unwatched{});
    return operations;
}

template <class Method, Form form>
Trace traceOne(const Segment& segment, const Window& window)
{
    if (form == Form::Corrected && !withinContract(segment, window))
        return {};
    operations = {};
    Recorder recorder;
    const auto piece = Method::template clip<form>(counted(segment), counted(window), recorder);
    Trace trace = recorder.take();
    if (piece && trace.outcome != Outcome::DidNotEnd) {
        trace.outcome = Outcome::Visible;
        trace.visible = plain(*piece);
    }
    return trace;
}

template <class Method, Form form>
constexpr Uses<Segment, Window> uses{clipOne<Method, form>, clipMany<Method, form>,
                                     countMany<Method, form>, traceOne<Method, form>};

template <class Method>
Algorithm describe()
{
    constexpr About about = Method::about;
    return {about.key,
            about.abbreviation,
            about.name,
            about.year,
            about.idea,
            about.ulps,
            uses<Method, Form::Corrected>,
            &uses<Method, Form::Published>,
            nullptr,
            nullptr,
            nullptr};
}

} // namespace clipping
