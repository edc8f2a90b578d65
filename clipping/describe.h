// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/labels.h"
#include "clipping/limits.h"
#include "clipping/line_or_ray.h"
#include "clipping/outcode.h"

// Makes the catalogue row of an algorithm from its two functions, `Method::published` and
// `Method::corrected`. The file of a row ends with `template Algorithm describe<ItsOwnName>();`.

namespace clipping {

/// The data of a row, given at the top of its file.
struct About {
    std::string_view key, abbreviation, name;
    int year;
    std::string_view idea;
    double ulps;
};

/// Whether the contract covers this input: all numbers finite, and min <= max.
template <class T, glm::length_t N>
constexpr bool withinContract(const BasicSegment<T, N>& s, const BasicWindow<T, N>& w)
{
    return legal(s) && legal(w);
}

/// Whether a form works in a frame without overflow. Published forms work on the input itself, and
/// a row with `unframed` handles all numbers itself.
template <class Method, Form form, class T>
constexpr bool framed()
{
    constexpr bool wanted = !requires { Method::unframed; };
    return wanted && form == Form::Corrected && std::is_floating_point_v<T>;
}

/// The input that an algorithm gets for a segment and a window, and the frame if the input is
/// transformed.
template <class T, glm::length_t N>
struct FramedInput {
    BasicSegment<T, N> segment;
    BasicWindow<T, N> window;
    std::optional<Frame<T, N>> frame;
};
template <class Method, Form form, class T, glm::length_t N>
std::optional<FramedInput<T, N>> framedInput(const BasicSegment<T, N>& s,
                                             const BasicWindow<T, N>& w)
{
    if (form == Form::Corrected && !withinContract(s, w))
        return std::nullopt;
    if constexpr (framed<Method, form, T>())
        if (const Frame<T, N> frame(s); !ordinary(s) || !ordinary(w))
            return FramedInput<T, N>{frame.into(s), frame.into(w), frame};
    return FramedInput<T, N>{s, w, std::nullopt};
}

/// Converts the result of an algorithm on `input` to the result for `segment` and `window`.
template <class Method, Form form, class T, glm::length_t N>
BasicSegment<T, N> answer(BasicSegment<T, N> found, const FramedInput<T, N>& input,
                          const BasicSegment<T, N>& segment, const BasicWindow<T, N>& window)
{
    if constexpr (framed<Method, form, T>()) {
        if (input.frame)
            found = input.frame->back(found, segment, window);
        // Both ends are one point but may be rounded differently.
        if (meetsInAPoint(segment, window))
            (outcodeOf(segment.b, window) == 0 ? found.a : found.b) =
                outcodeOf(segment.b, window) == 0 ? found.b : found.a;
    }
    return found;
}

/// Runs one form of a method.
template <class Method, Form form, class S, class W, class Step>
constexpr std::optional<S> run(const S& segment, const W& window, Step&& step)
{
    if constexpr (form == Form::Published)
        return Method::published(segment, window, step);
    else
        return Method::corrected(segment, window, step);
}

template <class Method, Form form, class T, glm::length_t N>
[[gnu::noinline]] std::optional<BasicSegment<T, N>> clipGiven(const BasicSegment<T, N>& segment,
                                                              const BasicWindow<T, N>& window)
{
    const auto input = framedInput<Method, form>(segment, window);
    if (!input)
        return std::nullopt;
    auto piece = run<Method, form>(input->segment, input->window, Unwatched{});
    if (piece)
        piece = answer<Method, form>(*piece, *input, segment, window);
    return piece;
}

/// One form of an algorithm for one window; tests that depend on the window alone run once.
template <class Method, Form form, class T, glm::length_t N>
class At {
public:
    explicit At(const BasicWindow<T, N>& window) : window_(window), easy_(easy(window)) {}

    std::optional<BasicSegment<T, N>> clip(const BasicSegment<T, N>& segment) const
    {
        if (easy_ && easy(segment)) [[likely]]
            return run<Method, form>(segment, window_, Unwatched{});
        return clipGiven<Method, form>(segment, window_);
    }

private:
    static bool hasExtent(const BasicWindow<T, N>& w)
    {
        for (glm::length_t k = 0; k < N; ++k)
            if (!(w.min[k] < w.max[k]))
                return false;
        return true;
    }
    static bool easy(const BasicWindow<T, N>& w)
    {
        if constexpr (framed<Method, form, T>())
            return ordinary(w) && hasExtent(w);
        else
            return form == Form::Published;
    }
    static bool easy(const BasicSegment<T, N>& s)
    {
        if constexpr (framed<Method, form, T>())
            return ordinary(s);
        else
            return form == Form::Published;
    }
    const BasicWindow<T, N>& window_;
    bool easy_;
};

template <class Method, Form form, class T, glm::length_t N>
std::optional<BasicSegment<T, N>> clipOne(const BasicSegment<T, N>& segment,
                                          const BasicWindow<T, N>& window)
{
    return At<Method, form, T, N>(window).clip(segment);
}

template <class Method, Form form, class T, glm::length_t N>
[[gnu::flatten]] // inlines the algorithm into the loop
std::size_t
clipMany(std::span<const BasicSegment<T, N>> in, const BasicWindow<T, N>& window,
         std::span<BasicClipped<BasicSegment<T, N>>> out)
{
    requireRoom(in.size(), out.size());
    const At<Method, form, T, N> at(window);
    std::size_t visible = 0;
    for (std::size_t i = 0; i < in.size(); ++i)
        if (const auto piece = at.clip(in[i]))
            out[visible++] = {*piece, static_cast<std::uint32_t>(i), cutOf(in[i], *piece, window)};
    return visible;
}

template <class Method, Form form, class T, glm::length_t N>
OperationCounts countMany(std::span<const BasicSegment<T, N>> in, const BasicWindow<T, N>& window)
{
    operations = {};
    for (const BasicSegment<T, N>& segment : in)
        if (const auto input = framedInput<Method, form>(segment, window))
            run<Method, form>(counted(input->segment), counted(input->window), Unwatched{});
    return operations;
}

template <class Method, Form form, class T, glm::length_t N>
BasicTrace<N> traceOne(const BasicSegment<T, N>& segment, const BasicWindow<T, N>& window)
{
    const auto input = framedInput<Method, form>(segment, window);
    if (!input)
        return {};
    operations = {};
    BasicRecorder<N> recorder;
    recorder.begin(inDouble(input->segment), inDouble(input->window));
    const auto piece = run<Method, form>(counted(input->segment), counted(input->window), recorder);
    BasicTrace<N> trace = recorder.take();
    if (piece && trace.outcome != Outcome::DidNotEnd) {
        trace.outcome = Outcome::Visible;
        trace.visible = inDouble(answer<Method, form>(plain(*piece), *input, segment, window));
    }
    if (input->frame)
        for (BasicStep<N>& step : trace.steps)
            step.segment = input->frame->outOf(step.segment);
    return trace;
}

/// Clips many segments. A row may have its own function for this: `Method::many<T>`.
template <class Method, Form form, class T, glm::length_t N>
constexpr auto manyOf()
{
    if constexpr (requires { Method::template many<T>; })
        return Method::template many<T>;
    else
        return clipMany<Method, form, T, N>;
}

template <class Method, Form form, class T = double, glm::length_t N = 2>
constexpr Functions<BasicSegment<T, N>, BasicWindow<T, N>> uses{
    clipOne<Method, form, T, N>, manyOf<Method, form, T, N>(), countMany<Method, form, T, N>,
    traceOne<Method, form, T, N>};

/// The published form; none if the row has `ours`.
template <class Method>
constexpr const Functions<Segment, Window>* publishedUses()
{
    if constexpr (requires { Method::ours; })
        return nullptr;
    else
        return &uses<Method, Form::Published>;
}

/// The forms for convex polygons (polygon/uses.h), if the row names them.
template <class Method>
constexpr const Functions<Segment, ConvexPolygon>* polygonOf()
{
    if constexpr (requires { Method::polygon; })
        return Method::polygon;
    else
        return nullptr;
}
template <class Method>
constexpr const Functions<Segment, ConvexPolygon>* polygonBySearchOf()
{
    if constexpr (requires { Method::polygonBySearch; })
        return Method::polygonBySearch;
    else
        return nullptr;
}

/// The form in three dimensions: the one that the row names (box/), or its corrected function if
/// that works for any number of axes; else none.
template <class Method>
constexpr const Functions<Segment3, Window3>* boxUses()
{
    if constexpr (requires { Method::box; })
        return Method::box;
    else if constexpr (requires(const Segment3& s, const Window3& w) {
                           Method::corrected(s, w, Unwatched{});
                       })
        return &uses<Method, Form::Corrected, double, 3>;
    else
        return nullptr;
}

/// The pseudo-code that is beside a form's function, without its first line feed.
template <class Method, Form form>
constexpr std::string_view codeBeside()
{
    std::string_view code;
    if constexpr (form == Form::Corrected && requires { Method::correctedCode; })
        code = Method::correctedCode;
    if constexpr (form == Form::Published && requires { Method::publishedCode; })
        code = Method::publishedCode;
    return code.starts_with('\n') ? code.substr(1) : code;
}

template <class Method>
Algorithm describe()
{
    constexpr About about = Method::about;
    static_assert(labelsAreUnique(codeBeside<Method, Form::Corrected>()));
    static_assert(labelsAreUnique(codeBeside<Method, Form::Published>()));
    return {about.key,
            about.abbreviation,
            about.name,
            about.year,
            about.idea,
            about.ulps,
            uses<Method, Form::Corrected>,
            publishedUses<Method>(),
            &uses<Method, Form::Corrected, float>,
            polygonOf<Method>(),
            polygonBySearchOf<Method>(),
            boxUses<Method>(),
            lineOrRayUsesOf<Method, Reach::BothWays>(),
            lineOrRayUsesOf<Method, Reach::OneWay>(),
            codeBeside<Method, Form::Corrected>(),
            codeBeside<Method, Form::Published>()};
}

} // namespace clipping
