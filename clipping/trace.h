// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/counted.h"

#include <string_view>
#include <utility>
#include <vector>

namespace clipping {

/// A value worth showing beside a step: an outcode, the t of an intersection, a slope.
struct NamedValue {
    std::string_view name;
    double value;
};

/// One moment in the run of an algorithm.
template <glm::length_t N>
struct BasicStep {
    std::string_view what; ///< "outcodes", "reject", "cut", ...
    int line; ///< of the algorithm's pseudo-code (resources/algorithms/KEY.md), from 1; 0 for what
              ///< it does not have, as it is in the plane
    BasicSegment<double, N> segment; ///< what is left
    Edge edge;                       ///< the edge it is about
    std::vector<NamedValue> values;
    OperationCounts cost; ///< since the start
};
using Step = BasicStep<2>;

enum class Outcome : std::uint8_t { Visible, Invisible, DidNotEnd };

/// A whole run. `visible` is what the same form's `clip` returns, bit for bit, when Visible.
template <glm::length_t N>
struct BasicTrace {
    std::vector<BasicStep<N>> steps;
    Outcome outcome = Outcome::Invisible;
    BasicSegment<double, N> visible{};
};
using Trace = BasicTrace<2>;

/// Watches nothing and costs nothing: what the fast path hands to an algorithm.
struct Unwatched {
    constexpr void operator()(const auto&...) const {}
    constexpr void didNotEnd() const {}
};

/// A value as an algorithm hands it to its watcher.
template <class T>
struct Named {
    std::string_view name;
    T value;
};
template <class T>
Named(const char*, T) -> Named<T>;

/// Writes every step down. An algorithm hands over what it has; it computes nothing to be watched.
template <glm::length_t N>
class BasicRecorder {
public:
    template <class Number, class... T>
    void operator()(std::string_view what, int line,
                    const BasicSegment<Counted<Number>, N>& segment, Edge edge,
                    const Named<T>&... values)
    {
        trace_.steps.push_back({what,
                                line,
                                inDouble(plain(segment)),
                                edge,
                                {NamedValue{values.name, plain(values.value)}...},
                                operations});
    }
    void didNotEnd() { trace_.outcome = Outcome::DidNotEnd; }
    bool ended() const { return trace_.outcome != Outcome::DidNotEnd; }
    BasicTrace<N> take() { return std::move(trace_); }

private:
    BasicTrace<N> trace_;
};
using Recorder = BasicRecorder<2>;

} // namespace clipping
