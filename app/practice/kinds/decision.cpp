// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/practice/kinds/kinds.h"

namespace app {

namespace {

/// Whether a step belongs to a decision: a further test of it, or what carries its result to the
/// line that accepts or rejects. Let "left" ends a turned plane, or holds the ends.
bool carriesOn(const clipping::Step& step, std::string_view also)
{
    return step.what == clipping::What::Test
               ? isWordOf(step.label, also)
               : step.what == clipping::What::Let
                     && (step.name == "display" || step.name == "left");
}

/// What the trace does after the test and what belongs to it.
Decision decisionAt(const MoveContext& context)
{
    const auto& steps = context.trace.steps;
    std::size_t k = context.step + 1;
    while (k < steps.size() && carriesOn(steps[k], context.planned.also))
        ++k;
    if (k >= steps.size())
        return Decision::GoOn;
    return steps[k].what == clipping::What::Accept   ? Decision::Accept
           : steps[k].what == clipping::What::Reject ? Decision::Reject
                                                     : Decision::GoOn;
}

void addMistakesOfDecisions(Move& move, Decision right)
{
    addMistake(move, "accepted", double(Decision::Accept),
               right == Decision::Reject
                   ? Text::tr("The test that accepts is not true: nothing of the line is known to "
                              "be visible. Read the condition once more.")
                   : Text::tr("It is too early to accept: not everything that is left is known to "
                              "be inside."));
    addMistake(move, "rejected", double(Decision::Reject),
               right == Decision::Accept
                   ? Text::tr("What is left of the line is inside, so it is not rejected.")
                   : Text::tr("It is too early to reject: a part may still be visible. Both ends "
                              "must be beyond the same edge, or nothing may be left."));
    addMistake(
        move, "went-on", double(Decision::GoOn),
        Text::tr("The tests decide here: no further work is needed. Put the numbers into the "
                 "conditions."));
}

std::optional<Move> makeDecision(const MoveContext& context)
{
    if (context.traced().what != clipping::What::Test)
        return std::nullopt;
    const Decision right = decisionAt(context);
    const int line = context.now().line;
    Move move{.prompt = Text::tr("Line %1: “%2”. What comes next: is the line accepted, is it "
                                 "rejected, or is there more to do first?")
                            .arg(line)
                            .arg(context.codeText(line)),
              .brief = Text::tr("Decision at line %1").arg(line),
              .right = double(right),
              .chance = 1.0 / 3,
              .hint = Text::tr("Put the numbers into the conditions, one after another.")};
    move.line = line;
    move.reason = context.now().sentence;
    addMistakesOfDecisions(move, right);
    return move;
}

QString decisionText(const Move&, double answer, YAxis)
{
    switch (Decision(int(answer))) {
    case Decision::Accept:
        return Text::tr("accept");
    case Decision::Reject:
        return Text::tr("reject");
    default:
        return Text::tr("more to do first");
    }
}

} // namespace

const MoveMaker decisionMaker{MoveKind::Decide, makeDecision, decisionText};

} // namespace app
