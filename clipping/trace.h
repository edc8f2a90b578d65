// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/counted.h"

#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace CLEARCUT_API clipping {

/// The kind of a value. Bits: an outcode or a pattern of corners. Whole: a count or an index.
/// Truth: true or false.
enum class ValueKind : std::uint8_t { Number, Whole, Bits, Truth };

/// The kind of a value, by the type of the algorithm's variable.
template <class T>
inline constexpr ValueKind kindOf = std::is_same_v<T, bool>       ? ValueKind::Truth
                                    : std::is_same_v<T, unsigned> ? ValueKind::Bits
                                    : std::is_integral_v<T>       ? ValueKind::Whole
                                                                  : ValueKind::Number;

/// A value shown with a step: an outcode, the t of an intersection, a slope.
struct NamedValue {
    std::string_view name;              ///< as in the pseudo-code: "t", "code1"
    double value;                       ///< in the drawing's unit, or without unit
    ValueKind kind = ValueKind::Number; ///< how to interpret `value`
};

/// The kind of a step. Test: evaluates a condition. Let: assigns a variable. Cut: moves an end of
/// the remaining segment. The last step is one of Accept: something is visible; Reject: nothing is
/// visible; GiveUp: a published form did not end and was stopped.
enum class What : std::uint8_t { Test, Let, Cut, Accept, Reject, GiveUp };

/// One step in the run of an algorithm.
template <glm::length_t N>
struct CLEARCUT_HOLDS_CONTAINERS BasicStep {
    What what;             ///< the kind of the step
    bool holds;            ///< the result of a Test; false for other steps
    std::string_view name; ///< of the assigned variable, for Let
    /// Label of its line in the form's pseudo-code (pseudo_code.h); empty for a step on the third
    /// axis, for which the pseudo-code has no line.
    std::string_view label;
    BasicSegment<double, N> segment; ///< the remaining segment after the step
    Edge edge;                       ///< the edge that the step concerns
    std::vector<NamedValue> values;  ///< variables assigned since the previous step
    OperationCounts cost;            ///< operations since the start
};
using Step = BasicStep<2>;

/// How a run ended. DidNotEnd: a published form did not end and was stopped at its cap.
enum class Outcome : std::uint8_t { Visible, Invisible, DidNotEnd };

/// A whole run. If the outcome is Visible, `visible` is bit for bit what the same form's `clip`
/// returns.
template <glm::length_t N>
struct CLEARCUT_HOLDS_CONTAINERS BasicTrace {
    std::vector<BasicStep<N>> steps;      ///< in the order of the run; empty for invalid input
    Outcome outcome = Outcome::Invisible; ///< how the run ended
    BasicSegment<double, N> visible{};    ///< the visible piece, if Visible
};
using Trace = BasicTrace<2>;

/// Records nothing and costs nothing: the `step` argument of an algorithm on the fast path.
///
/// Its functions are those by which an algorithm reports its steps, each with the label of
/// the step's line in the form's pseudo-code. They return their argument, so that a line of the
/// code and its step are one expression: here `step.test(l, c)` is just `(c)`, and `step.let(l, n,
/// v)` is `(v)`.
struct Unwatched {
    /// Tests a condition about an edge, or about the two edges of an axis; returns the condition.
    constexpr bool test(std::string_view, bool condition, Edge = Edge::NoEdge,
                        Edge = Edge::NoEdge) const
    {
        return condition;
    }
    /// Assigns a variable, possibly for an intersection with an edge; returns the value.
    template <class T>
    constexpr T let(std::string_view, std::string_view, T value, Edge = Edge::NoEdge) const
    {
        return value;
    }
    /// Assigns a variable without a step of its own; returns the value.
    template <class T>
    constexpr T set(std::string_view, T value) const
    {
        return value;
    }
    /// Moves an end of the segment, 0 for a and 1 for b, to a point (or x, y) on an edge. Instead
    /// of the edge, the name of a variable may be given: then it is the edge of that variable's
    /// Let.
    constexpr void cut(std::string_view, int, const auto&...) const {}
    /// Replaces both ends of the remaining segment.
    constexpr void left(std::string_view, const auto&, Edge = Edge::NoEdge) const {}
    /// Ends the run: nothing is visible.
    constexpr std::nullopt_t reject(std::string_view) const { return std::nullopt; }
    /// Ends the run: a published form does not end and is stopped.
    constexpr std::nullopt_t giveUp(std::string_view) const { return std::nullopt; }
    /// Ends the run: a segment is visible; returns the segment.
    template <class S>
    constexpr std::optional<S> accept(std::string_view, const S& visible) const
    {
        return visible;
    }
};

/// Records every step. An algorithm passes values that it has computed anyway, and computes nothing
/// extra for the recorder.
template <glm::length_t N>
class CLEARCUT_HOLDS_CONTAINERS BasicRecorder {
public:
    /// Sets the segment and the window that the algorithm starts with.
    void begin(const BasicSegment<double, N>& segment, const BasicWindow<double, N>& window)
    {
        left_ = segment, window_ = window;
    }
    /// The functions of Unwatched, which record here.
    /// @{
    bool test(std::string_view label, bool condition, Edge edge = Edge::NoEdge,
              Edge other = Edge::NoEdge)
    {
        if (other != Edge::NoEdge) // if it holds, the edge that both ends are beyond
            edge = !condition ? Edge::NoEdge : isBeyond(other) ? other : edge;
        return tell({What::Test, condition}, label, edge), condition;
    }
    template <class T>
    T let(std::string_view label, std::string_view name, T value, Edge edge = Edge::NoEdge)
    {
        return set(name, value), tell({What::Let, false, name}, label, edge), value;
    }
    template <class T>
    T set(std::string_view name, T value)
    {
        new_.push_back({name, plain(value), kindOf<T>});
        return value;
    }
    template <class T>
    void cut(std::string_view label, int end, const glm::vec<N, Counted<T>>& to, Edge edge)
    {
        (end == 0 ? left_.a : left_.b) = glm::vec<N, double>(values(to));
        tell({What::Cut}, label, edge);
    }
    template <class T>
    void cut(std::string_view label, int end, T x, T y, Edge edge)
    {
        cut(label, end, glm::vec<2, T>(x, y), edge);
    }
    template <class T>
    void cut(std::string_view label, int end, T x, T y, std::string_view variable)
    {
        Edge edge = Edge::NoEdge;
        for (const BasicStep<N>& step : trace_.steps)
            if (step.what == What::Let && step.name == variable)
                edge = step.edge;
        cut(label, end, x, y, edge);
    }
    template <class S>
    void left(std::string_view label, const S& segment, Edge edge = Edge::NoEdge)
    {
        left_ = inDouble(plain(segment));
        tell({What::Let, false, "left"}, label, edge);
    }
    std::nullopt_t giveUp(std::string_view label)
    {
        trace_.outcome = Outcome::DidNotEnd;
        return tell({What::GiveUp}, label, Edge::NoEdge), std::nullopt;
    }
    std::nullopt_t reject(std::string_view label)
    {
        tell({What::Reject}, label, trace_.steps.empty() ? Edge::NoEdge : trace_.steps.back().edge);
        return std::nullopt;
    }
    template <class S>
    std::optional<S> accept(std::string_view label, const S& visible)
    {
        left_ = inDouble(plain(visible));
        return tell({What::Accept}, label, Edge::NoEdge), visible;
    }
    /// @}
    /// Returns the recorded trace; the recorder is empty afterwards.
    BasicTrace<N> take() { return std::move(trace_); }

private:
    BasicTrace<N> trace_;
    BasicSegment<double, N> left_{};
    BasicWindow<double, N> window_{};
    std::vector<NamedValue> new_; ///< assigned since the previous step

    struct Word {
        What what;
        bool holds = false;
        std::string_view name{};
    };
    void tell(Word word, std::string_view label, Edge edge)
    {
        trace_.steps.push_back({word.what, word.holds, word.name, label, left_, edge,
                                std::exchange(new_, {}), operations});
    }
    /// Whether both ends of the remaining segment are beyond an edge.
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
