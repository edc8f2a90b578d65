// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/counted.h"

#include <optional>
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

/// What a step does: asks a question, gives a variable its value, moves an end of what is left;
/// or is the last: something is visible, nothing is, a published form went round until it was
/// stopped.
enum class What : std::uint8_t { Test, Let, Cut, Accept, Reject, GiveUp };

/// One step in the run of an algorithm.
template <glm::length_t N>
struct BasicStep {
    What what;
    bool holds;            ///< the answer of a Test; false of other steps
    std::string_view name; ///< of the variable that gets its value
    int line; ///< of the form's pseudo-code (`codeOf` in algorithm.h), from 1; 0 for what it does
              ///< not have, as it is in the plane
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

/// Records nothing and costs nothing: what the fast path hands to an algorithm as its `step`.
///
/// The words in which an algorithm tells its steps, each with its line of the form's pseudo-code.
/// They return what they were given, so that a line of the code and its step are one expression:
/// without a listener `step.test(l, c)` is `(c)`, and `step.let(l, n, v)` is `(v)`.
struct Unwatched {
    /// A question about an edge, or about the two edges of an axis; whether the condition holds.
    constexpr bool test(int, bool condition, Edge = Edge::None, Edge = Edge::None) const
    {
        return condition;
    }
    /// A variable gets its value, on the way to an edge; the value.
    template <class T>
    constexpr T let(int, std::string_view, T value, Edge = Edge::None) const
    {
        return value;
    }
    /// What a variable is from here on, without a step of its own; the value.
    template <class T>
    constexpr T set(std::string_view, T value) const
    {
        return value;
    }
    /// An end of the segment, 0 for a and 1 for b, moves to a point (or x, y) of an edge, or of
    /// the edge at which the variable of a name got its value.
    constexpr void cut(int, int, const auto&...) const {}
    /// What is left is another segment now, with both its ends.
    constexpr void left(int, const auto&, Edge = Edge::None) const {}
    /// Nothing is visible.
    constexpr std::nullopt_t reject(int) const { return std::nullopt; }
    /// A published form goes round and round, and is stopped.
    constexpr std::nullopt_t giveUp(int) const { return std::nullopt; }
    /// A segment is visible; the segment.
    template <class S>
    constexpr std::optional<S> accept(int, const S& visible) const
    {
        return visible;
    }
};

/// Writes every step down. An algorithm hands over what it has; it computes nothing to be watched.
template <glm::length_t N>
class BasicRecorder {
public:
    /// What the algorithm begins with.
    void begin(const BasicSegment<double, N>& segment, const BasicWindow<double, N>& window)
    {
        left_ = segment, window_ = window;
    }
    /// The words of Unwatched, which are written down here.
    /// @{
    bool test(int line, bool condition, Edge edge = Edge::None, Edge other = Edge::None)
    {
        if (other != Edge::None) // one of two edges if it holds, else about neither of them
            edge = !condition ? Edge::None : isBeyond(other) ? other : edge;
        return tell({What::Test, condition}, line, edge), condition;
    }
    template <class T>
    T let(int line, std::string_view name, T value, Edge edge = Edge::None)
    {
        return set(name, value), tell({What::Let, false, name}, line, edge), value;
    }
    template <class T>
    T set(std::string_view name, T value)
    {
        new_.push_back({name, plain(value), kindOf<T>});
        return value;
    }
    template <class T>
    void cut(int line, int end, const glm::vec<N, Counted<T>>& to, Edge edge)
    {
        (end == 0 ? left_.a : left_.b) = glm::vec<N, double>(values(to));
        tell({What::Cut}, line, edge);
    }
    template <class T>
    void cut(int line, int end, T x, T y, Edge edge)
    {
        cut(line, end, glm::vec<2, T>(x, y), edge);
    }
    template <class T>
    void cut(int line, int end, T x, T y, std::string_view variable)
    {
        Edge edge = Edge::None;
        for (const BasicStep<N>& step : trace_.steps)
            if (step.what == What::Let && step.name == variable)
                edge = step.edge;
        cut(line, end, x, y, edge);
    }
    template <class S>
    void left(int line, const S& segment, Edge edge = Edge::None)
    {
        left_ = inDouble(plain(segment));
        tell({What::Let, false, "left"}, line, edge);
    }
    std::nullopt_t giveUp(int line)
    {
        trace_.outcome = Outcome::DidNotEnd;
        return tell({What::GiveUp}, line, Edge::None), std::nullopt;
    }
    std::nullopt_t reject(int line)
    {
        tell({What::Reject}, line, trace_.steps.empty() ? Edge::None : trace_.steps.back().edge);
        return std::nullopt;
    }
    template <class S>
    std::optional<S> accept(int line, const S& visible)
    {
        left_ = inDouble(plain(visible));
        return tell({What::Accept}, line, Edge::None), visible;
    }
    /// @}
    /// What was written down; the recorder is empty afterwards.
    BasicTrace<N> take() { return std::move(trace_); }

private:
    BasicTrace<N> trace_;
    BasicSegment<double, N> left_{};
    BasicWindow<double, N> window_{};
    std::vector<NamedValue> new_; ///< since the step before

    struct Word {
        What what;
        bool holds = false;
        std::string_view name{};
    };
    void tell(Word word, int line, Edge edge)
    {
        trace_.steps.push_back({word.what, word.holds, word.name, line, left_, edge,
                                std::exchange(new_, {}), operations});
    }
    /// Whether both ends of what is left are beyond an edge.
    bool isBeyond(Edge edge) const
    {
        const glm::length_t k = axisOf(edge);
        const double level = levelOf(edge, window_);
        return edge == lowerEdge(k) ? left_.a[k] < level && left_.b[k] < level
                                    : left_.a[k] > level && left_.b[k] > level;
    }
};
using Recorder = BasicRecorder<2>;

} // namespace clipping
