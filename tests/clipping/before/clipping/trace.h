// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/counted.h"

#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace clipping {

/// What a value is: Bits an outcode or a pattern of corners, Whole a number that counts or numbers.
enum class ValueKind : std::uint8_t { Number, Whole, Bits, Truth };

/// How a value is to be read, by the type that the algorithm keeps it in.
template <class T>
inline constexpr ValueKind kindOf = std::is_same_v<T, bool>       ? ValueKind::Truth
                                    : std::is_same_v<T, unsigned> ? ValueKind::Bits
                                    : std::is_integral_v<T>       ? ValueKind::Whole
                                                                  : ValueKind::Number;

/// A value worth showing beside a step: an outcode, the t of an intersection, a slope.
struct NamedValue {
    std::string_view name;              ///< as in the pseudo-code: "t", "code1"
    double value;                       ///< in the drawing's units, or a bare number
    ValueKind kind = ValueKind::Number; ///< how it is to be read
};

/// One moment in the run of an algorithm.
template <glm::length_t N>
struct BasicStep {
    std::string_view what; ///< "accept", "reject", "give up"; "cut ..."; of a test on `line`
                           ///< whether it held: "yes", "no"; or what is found: "outcodes", "t", ...
    int line; ///< of the algorithm's pseudo-code (resources/algorithms/KEY.md), from 1; 0 for what
              ///< it does not have, as it is in the plane
    BasicSegment<double, N> segment; ///< what is left
    Edge edge;                       ///< the edge it is about
    std::vector<NamedValue> values;  ///< what the algorithm had at hand
    OperationCounts cost;            ///< since the start
};
using Step = BasicStep<2>;

/// How a run ended. DidNotEnd: a published form went round until it was stopped.
enum class Outcome : std::uint8_t { Visible, Invisible, DidNotEnd };

/// A whole run. `visible` is what the same form's `clip` returns, bit for bit, when Visible.
template <glm::length_t N>
struct BasicTrace {
    std::vector<BasicStep<N>> steps;      ///< in the order of the run; none for illegal input
    Outcome outcome = Outcome::Invisible; ///< how it ended
    BasicSegment<double, N> visible{};    ///< what is left, if Visible
};
using Trace = BasicTrace<2>;

/// Watches nothing and costs nothing: what the fast path hands to an algorithm.
struct Unwatched {
    constexpr void operator()(const auto&...) const {} ///< a step
    constexpr void didNotEnd() const {}                ///< the run was stopped
};

/// A value as an algorithm hands it to its watcher.
template <class T>
struct Named {
    std::string_view name; ///< as in the pseudo-code
    T value;               ///< counted or not
};
template <class T>
Named(const char*, T) -> Named<T>;

/// Writes every step down. An algorithm hands over what it has; it computes nothing to be watched.
template <glm::length_t N>
class BasicRecorder {
public:
    /// A step: what was done, on which line of the pseudo-code, what is left of the segment, the
    /// edge it is about, and what the algorithm had at hand. The cost is the thread's so far.
    template <class Number, class... T>
    void operator()(std::string_view what, int line,
                    const BasicSegment<Counted<Number>, N>& segment, Edge edge,
                    const Named<T>&... values)
    {
        trace_.steps.push_back(
            {what,
             line,
             inDouble(plain(segment)),
             edge,
             {NamedValue{values.name, plain(values.value), kindOf<T>}...},
             operations});
    }
    /// The run was stopped.
    void didNotEnd() { trace_.outcome = Outcome::DidNotEnd; }
    /// What was written down; the recorder is empty afterwards.
    BasicTrace<N> take() { return std::move(trace_); }

private:
    BasicTrace<N> trace_;
};
using Recorder = BasicRecorder<2>;

} // namespace clipping
