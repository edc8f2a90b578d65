// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/teaching/formulas/step_check.h"

#include "clipping/clamped.h"

#include <algorithm>

#include "tests/app/teaching/formulas/exact_functions.h"

namespace app::formulas {

using clipping::What;

namespace {

std::array<double, 4> coordinates(const clipping::Segment& s) { return Plane().of(s); }

/// Whether both ends, or one, are said to be new.
bool movesEnds(const clipping::Step& step)
{
    return step.what == What::Cut || (step.what == What::Let && step.name == "left");
}

std::string text(bool truth) { return truth ? "true" : "false"; }

} // namespace

StepCheck::StepCheck(const Code& code, std::vector<char>& evaluated,
                     std::vector<char>& comparedLess, const clipping::Segment& segment,
                     const clipping::Window& window)
    : code_(code), evaluated_(evaluated), comparedLess_(comparedLess),
      scope_(code.names, segment, window), left_(segment), ends_(coordinates(segment))
{
    scope_.exact = &exactFunctions;
    setEnds();
}

void StepCheck::step(const clipping::Step& step)
{
    const int line = clipping::lineOf(code_.labels, step.label);
    if (line < 1)
        throw Wrong{"no line has this label", std::string(step.label)};
    line_ = &code_.lines[std::size_t(line) - 1];
    next_ = ends_, assignsEnds_ = false;
    shown_ = {};
    windowBefore_ = scope_.window();
    const bool isDone = line_->turns && movesEnds(step);
    if (isDone)
        turnBack(step);
    scope_.edge = plane_.of(step.edge);
    words(step.what);
    takeFromOtherLines(step);
    if (step.what == What::Test)
        condition(step.holds);
    if (step.what == What::Let && !movesEnds(step))
        nameOfLet(step);
    if (step.what == What::Cut)
        conditionOfCut();
    assignments(step);
    if (!isDone)
        arguments(step);
    ends(step);
    cost(step);
}

void StepCheck::words(What what) const
{
    const auto must = [](bool has, const char* word) {
        if (!has)
            throw Wrong{std::string("the line does not say \"") + word + '"', word};
    };
    must(what != What::Accept || line_->accepts, "accept");
    must(what != What::Reject || line_->rejects, "reject");
    must(what != What::GiveUp || line_->givesUp, "give up");
    must(what != What::Test || line_->condition.has_value(), "if");
    if ((what == What::Accept || what == What::Reject) && !turns_.empty())
        throw Wrong{"the plane is turned back before the end", "that it is not"};
}

void StepCheck::condition(bool holds)
{
    const bool found = valueOf(*line_->condition) != 0;
    if (found != holds)
        throw Wrong{text(found), text(holds)};
}

/// A line that cuts under a condition has been chosen by it, without a step of its own or with one.
void StepCheck::conditionOfCut()
{
    if (!line_->condition)
        return;
    evaluated_[line_->condition->number] = 1;
    if (formulas::valueOf(line_->condition->expression, scope_) == 0)
        throw Wrong{"the condition of the line does not hold", "a cut"};
}

void StepCheck::assignments(const clipping::Step& step)
{
    for (const Assignment& assignment : line_->assignments) {
        const int slot = slotOf(assignment.target, scope_);
        const auto end = std::ranges::find(code_.ends, slot) - code_.ends.begin();
        const bool isEnd = end < 4 && movesEnds(step);
        const auto value = told(step, slot);
        if (!isEnd && !value)
            continue;
        scope_.axis = end < 4 ? int(end % 2) : axisOf(slot);
        const double found = valueOf(assignment.value);
        scope_.axis = -1;
        if (value && !same(found, *value))
            throw Wrong{code_.names.at(slot) + " = " + formulas::text(found),
                        formulas::text(*value)};
        scope_.set(slot, found);
        scope_.setEdge(slot, scope_.edge);
        if (isEnd)
            next_[std::size_t(end)] = found, assignsEnds_ = true;
    }
}

/// Whether an end lies on the edge that a cut names; a line that holds ends puts them there
/// exactly.
bool StepCheck::isOnItsEdge() const
{
    if (scope_.edge == clipping::Edge::NoEdge)
        return true;
    const auto axis = std::size_t(clipping::axisOf(scope_.edge));
    const double level = clipping::levelOf(scope_.edge, scope_.window());
    return next_[axis] == level || next_[axis + 2] == level;
}

void StepCheck::ends(const clipping::Step& step)
{
    if (movesEnds(step) && !assignsEnds_ && !line_->turns) {
        if (!line_->holds)
            throw Wrong{"the line gives no end a new coordinate", "new ends"};
        const auto [a, b] =
            std::pair(glm::dvec2{ends_[0], ends_[1]}, glm::dvec2{ends_[2], ends_[3]});
        const auto w = scope_.window();
        next_ = coordinates({clipping::clamped(a, w), clipping::clamped(b, w)});
    }
    if (step.what == What::Accept)
        for (std::size_t k = 0; k < line_->accepted.size(); ++k)
            next_[k] = valueOf(line_->accepted[k]);
    if (step.what == What::Cut && line_->comparesInFunctions && !isOnItsEdge())
        throw Wrong{"the new end is not on the edge", "an edge"};
    const Ends now = plane_.of(step.segment);
    for (std::size_t k = 0; k < 4; ++k)
        if (!same(next_[k], now[k]))
            throw Wrong{std::string(k % 2 ? "y" : "x") + " of End " + (k < 2 ? "1" : "2") + " = "
                            + formulas::text(next_[k]),
                        formulas::text(now[k])};
    left_ = step.segment, ends_ = now;
    setEnds();
}

} // namespace app::formulas
