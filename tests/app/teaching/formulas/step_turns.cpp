// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/teaching/formulas/step_check.h"

// A call in a plane that is turned or mirrored: its window is that of the arguments, the ends go
// along, and when it is done they are told once more, turned back, as what is left.

namespace app::formulas {

namespace {

/// The argument for a parameter that is an edge of the window.
const Expression& argumentFor(int edge, const Arguments& call, const Parameters& parameters)
{
    for (std::size_t k = 0; k < parameters.variables.size(); ++k)
        if (parameters.variables[k] == edge)
            return call.values[k].expression;
    throw Unreadable(call.of + " takes no window that could be turned");
}

/// The plane in which the window is that of the arguments.
Plane turned(const Plane& before, const Arguments& call, const Parameters& parameters)
{
    Plane plane;
    for (std::size_t k = 0; k < 2; ++k) {
        const Expression& argument = argumentFor(int(4 + k), call, parameters); // xmin, ymin
        const bool isNegative = argument.kind == Kind::Negative;
        const Expression& edge = isNegative ? argument.parts[0] : argument;
        if (edge.kind != Kind::Name || !isEdge(edge.variables[0]))
            throw Unreadable(call.of + " takes no edge of the window");
        const auto axis = std::size_t(edge.variables[0] % 2);
        plane.axes[k] = before.axes[axis];
        plane.isNegative[k] = before.isNegative[axis] != isNegative;
    }
    if (plane.axes[0] == plane.axes[1])
        throw Unreadable(call.of + " takes one axis twice");
    return plane;
}

} // namespace

void StepCheck::turn(const clipping::Step& step, const Arguments& call,
                     const Parameters& parameters)
{
    turns_.push_back({line_, plane_, windowBefore_});
    plane_ = turned(plane_, call, parameters);
    next_ = ends_ = plane_.of(left_);
    setEnds();
    checkGiven(step);
}

void StepCheck::turnBack(const clipping::Step& step)
{
    if (turns_.empty() || turns_.back().line != line_)
        throw Wrong{"the plane was not turned here", "turned back"};
    plane_ = turns_.back().before;
    scope_.setWindow(turns_.back().window);
    turns_.pop_back();
    next_ = ends_ = plane_.of(left_);
    setEnds();
    checkGiven(step);
}

/// Ends and edges that are told are those of the plane as it is now.
void StepCheck::checkGiven(const clipping::Step& step) const
{
    for (int slot = 0; isGivenEnd(slot) || isEdge(slot); ++slot)
        if (const auto value = told(step, slot); value && !same(*value, scope_.value(slot)))
            throw Wrong{code_.names.at(slot) + " = " + text(scope_.value(slot)), text(*value)};
}

} // namespace app::formulas
