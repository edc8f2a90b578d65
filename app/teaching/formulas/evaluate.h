// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/formulas/expression.h"
#include "clipping/counted.h"

namespace app::formulas {

/// What the code calls order, yAt and xAt, and side: the library keeps its exact arithmetic for
/// itself, so it is lent. Each takes the given ends first.
struct ExactFunctions {
    int (*order)(const clipping::Segment& ends, double x, double y); ///< −1, 0 or 1
    double (*crossing)(const clipping::Segment& ends, double x);     ///< the y at x, rounded once
    int (*side)(const clipping::Segment& ends, const glm::dvec2& point); ///< 1: left of the line
};

/// What formulas are evaluated with.
class Scope {
public:
    Scope(const Names& names, const clipping::Segment& segment, const clipping::Window& window);

    bool isKnown(int slot) const { return known_[std::size_t(slot)] != 0; }
    double value(int slot) const; ///< throws Unreadable if it is not known
    void set(int slot, double value);
    /// The edge of the step that gave a variable its value.
    clipping::Edge edgeOf(int slot) const { return edges_[std::size_t(slot)]; }
    void setEdge(int slot, clipping::Edge of) { edges_[std::size_t(slot)] = of; }
    /// Whether it is a coordinate or computed from coordinates, not an outcode, a count or a truth.
    bool isNumber(int slot) const { return numbers_[std::size_t(slot)] != 0; }
    void setIsNumber(int slot, bool is) { numbers_[std::size_t(slot)] = is; }
    clipping::Window window() const; ///< of xmin, ymin, xmax, ymax
    void setWindow(const clipping::Window& window);
    std::string text() const; ///< every known variable with its value

    clipping::Edge edge = clipping::Edge::NoEdge; ///< that the step is about
    const ExactFunctions* exact = nullptr;        ///< without them their formulas are Unreadable
    int axis = -1; ///< of the coordinate that gets the value; -1: it is none

private:
    const Names& names_;
    std::vector<double> values_;
    std::vector<char> known_, numbers_;
    std::vector<clipping::Edge> edges_;
};

/// The slot of a Name or an Element.
int slotOf(const Expression& variable, const Scope& scope);

/// The value in double, from left to right; a truth is 1 or 0. Throws Unreadable. Adds to `cost`,
/// unless it is null, what the evaluation costs, as the text shows it: an operand that decides ends
/// an `and` or an `or`, a choice costs its condition and the alternative that it takes, and the
/// arguments of a function are evaluated. A function that compares costs what the library's own
/// does with these arguments; one that computes (callsArithmetic), the most that it can.
double valueOf(const Expression& e, const Scope& scope, clipping::OperationCounts* cost = nullptr);

/// The outermost operation of a formula. Only operations on numbers are counted, not those on
/// outcodes, indices and truths.
clipping::OperationCounts operationOf(const Expression& e, const Scope& scope);

/// Whether an operand of a formula is a coordinate or computed from coordinates.
bool operatesOnNumbers(const Expression& e, const Scope& scope);

/// The most that a function's own computing costs, without its arguments: nothing for one that only
/// compares.
clipping::OperationCounts mostCostOf(const Expression& function);

/// A number that reads back as it is.
std::string text(double value);

/// Whether they are the same bits, or both not a number.
bool same(double a, double b);

} // namespace app::formulas
