// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/algorithm.h"
#include "clipping/frame.h"
#include "clipping/outcode.h"

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

/// Whether the contract promises anything for this input: all finite, and min <= max.
template <class T>
constexpr bool withinContract(const BasicSegment<T>& s, const BasicWindow<T>& w)
{
    return legal(s) && legal(w);
}

/// The edge of the window on which a new end lies.
template <class T>
constexpr Edge edgeAt(const glm::vec<2, T>& p, const BasicWindow<T>& w)
{
    return p.x == w.min.x   ? Edge::Left
           : p.x == w.max.x ? Edge::Right
           : p.y == w.min.y ? Edge::Bottom
           : p.y == w.max.y ? Edge::Top
                            : Edge::None;
}

/// Which ends of `piece` are not those of `whole`, and on which edges they lie.
template <class T>
constexpr std::uint32_t cutOf(const BasicSegment<T>& whole, const BasicSegment<T>& piece,
                              const BasicWindow<T>& w)
{
    return cutAt(piece.a == whole.a ? Edge::None : edgeAt(piece.a, w),
                 piece.b == whole.b ? Edge::None : edgeAt(piece.b, w));
}

/// Whether a form works in a frame where there is no overflow. Published forms take what comes, and
/// a row that says `ours` copes with any number by itself.
template <class Method, Form form, class T>
constexpr bool framed()
{
    return form == Form::Corrected && std::is_same_v<T, double> && !requires { Method::ours; };
}

/// What an algorithm is given for a segment and a window, and the frame if that is not they.
template <class T>
struct Given {
    BasicSegment<T> segment;
    BasicWindow<T> window;
    std::optional<Frame> frame;
};
template <class Method, Form form, class T>
std::optional<Given<T>> givenFor(const BasicSegment<T>& s, const BasicWindow<T>& w)
{
    if (form == Form::Corrected && !withinContract(s, w))
        return std::nullopt;
    if constexpr (framed<Method, form, T>())
        if (const Frame frame(s); !ordinary(s) || !ordinary(w))
            return Given<T>{frame.into(s), frame.into(w), frame};
    return Given<T>{s, w, std::nullopt};
}

/// Whether a segment meets a window in one point at most: it runs across one that has no height, or
/// no width.
constexpr bool meetsInAPoint(const Segment& s, const Window& w)
{
    return (w.min.x == w.max.x && s.a.x != s.b.x) || (w.min.y == w.max.y && s.a.y != s.b.y);
}

/// What an algorithm found for what it was given, as the answer about `segment` and `window`.
template <class Method, Form form, class T>
BasicSegment<T> answer(BasicSegment<T> found, const Given<T>& given, const BasicSegment<T>& segment,
                       const BasicWindow<T>& window)
{
    if constexpr (framed<Method, form, T>()) {
        if (given.frame)
            found = given.frame->back(found, segment, window);
        if (meetsInAPoint(segment, window)) // which each end may have rounded in its own way
            (outcodeOf(segment.b, window) == 0 ? found.a : found.b) =
                outcodeOf(segment.b, window) == 0 ? found.b : found.a;
    }
    return found;
}

template <class Method, Form form, class T>
[[gnu::noinline]] std::optional<BasicSegment<T>> clipGiven(const BasicSegment<T>& segment,
                                                           const BasicWindow<T>& window)
{
    const auto given = givenFor<Method, form>(segment, window);
    if (!given)
        return std::nullopt;
    auto piece = Method::template clip<form>(given->segment, given->window, Unwatched{});
    if (piece)
        piece = answer<Method, form>(*piece, *given, segment, window);
    return piece;
}

/// One form of an algorithm at one window: what is asked of the window is asked once.
template <class Method, Form form, class T>
class At {
public:
    explicit At(const BasicWindow<T>& window) : window_(window), easy_(easy(window)) {}

    std::optional<BasicSegment<T>> clip(const BasicSegment<T>& segment) const
    {
        if (easy_ && easy(segment)) [[likely]]
            return Method::template clip<form>(segment, window_, Unwatched{});
        return clipGiven<Method, form>(segment, window_);
    }

private:
    static bool easy(const BasicWindow<T>& w)
    {
        if constexpr (framed<Method, form, T>())
            return ordinary(w) && w.min.x < w.max.x && w.min.y < w.max.y;
        else
            return form == Form::Published;
    }
    static bool easy(const BasicSegment<T>& s)
    {
        if constexpr (framed<Method, form, T>())
            return ordinary(s);
        else
            return form == Form::Published;
    }
    const BasicWindow<T>& window_;
    bool easy_;
};

template <class Method, Form form, class T>
std::optional<BasicSegment<T>> clipOne(const BasicSegment<T>& segment, const BasicWindow<T>& window)
{
    return At<Method, form, T>(window).clip(segment);
}

template <class Method, Form form, class T>
[[gnu::flatten]] // the loop must contain the algorithm, not call it
std::size_t
clipMany(std::span<const BasicSegment<T>> in, const BasicWindow<T>& window,
         std::span<BasicClipped<BasicSegment<T>>> out)
{
    assert(out.size() >= in.size());
    const At<Method, form, T> at(window);
    std::size_t visible = 0;
    for (std::size_t i = 0; i < in.size(); ++i)
        if (const auto piece = at.clip(in[i]))
            out[visible++] = {*piece, static_cast<std::uint32_t>(i), cutOf(in[i], *piece, window)};
    return visible;
}

template <class Method, Form form, class T>
OperationCounts countMany(std::span<const BasicSegment<T>> in, const BasicWindow<T>& window)
{
    operations = {};
    for (const BasicSegment<T>& segment : in)
        if (const auto given = givenFor<Method, form>(segment, window))
            Method::template clip<form>(counted(given->segment), counted(given->window),
                                        Unwatched{});
    return operations;
}

template <class Method, Form form, class T>
Trace traceOne(const BasicSegment<T>& segment, const BasicWindow<T>& window)
{
    const auto given = givenFor<Method, form>(segment, window);
    if (!given)
        return {};
    operations = {};
    Recorder recorder;
    const auto piece =
        Method::template clip<form>(counted(given->segment), counted(given->window), recorder);
    Trace trace = recorder.take();
    if (piece && trace.outcome != Outcome::DidNotEnd) {
        trace.outcome = Outcome::Visible;
        trace.visible = inDouble(answer<Method, form>(plain(*piece), *given, segment, window));
    }
    if (given->frame)
        for (Step& step : trace.steps)
            step.segment = given->frame->outOf(step.segment);
    return trace;
}

/// A row may bring its own way to clip many: `Method::many<T>`.
template <class Method, Form form, class T>
constexpr auto manyOf()
{
    if constexpr (requires { Method::template many<T>; })
        return Method::template many<T>;
    else
        return clipMany<Method, form, T>;
}

template <class Method, Form form, class T = double>
constexpr Uses<BasicSegment<T>, BasicWindow<T>> uses{
    clipOne<Method, form, T>, manyOf<Method, form, T>(), countMany<Method, form, T>,
    traceOne<Method, form, T>};

/// The published form; none where the row says `ours`.
template <class Method>
constexpr const Uses<Segment, Window>* publishedUses()
{
    if constexpr (requires { Method::ours; })
        return nullptr;
    else
        return &uses<Method, Form::Published>;
}

/// The form for float data; none unless the row says `single`.
template <class Method>
constexpr const Uses<BasicSegment<float>, BasicWindow<float>>* singleUses()
{
    if constexpr (requires { Method::single; })
        return &uses<Method, Form::Corrected, float>;
    else
        return nullptr;
}

/// The forms for convex polygons (polygon/uses.h), where the row names them.
template <class Method>
constexpr const Uses<Segment, ConvexPolygon>* polygonOf()
{
    if constexpr (requires { Method::polygon; })
        return Method::polygon;
    else
        return nullptr;
}
template <class Method>
constexpr const Uses<Segment, ConvexPolygon>* searchedPolygonOf()
{
    if constexpr (requires { Method::searchedPolygon; })
        return Method::searchedPolygon;
    else
        return nullptr;
}

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
            publishedUses<Method>(),
            singleUses<Method>(),
            polygonOf<Method>(),
            searchedPolygonOf<Method>(),
            nullptr};
}

} // namespace clipping
