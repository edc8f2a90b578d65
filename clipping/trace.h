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
struct Step {
    std::string_view what; ///< "outcodes", "reject", "cut", ...
    int line;              ///< of the algorithm's pseudo-code (resources/algorithms/KEY.md), from 1
    Segment segment;       ///< what is left
    Edge edge;             ///< the edge it is about
    std::vector<NamedValue> values;
    OperationCounts cost; ///< since the start
};

enum class Outcome : std::uint8_t { Visible, Invisible, DidNotEnd };

/// A whole run. `visible` is what the same form's `clip` returns, bit for bit, when Visible.
struct Trace {
    std::vector<Step> steps;
    Outcome outcome = Outcome::Invisible;
    Segment visible{};
};

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
class Recorder {
public:
    template <class N, class... T>
    void operator()(std::string_view what, int line, const BasicSegment<Counted<N>>& segment,
                    Edge edge, const Named<T>&... values)
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
    Trace take() { return std::move(trace_); }

private:
    Trace trace_;
};

} // namespace clipping
