// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/overlays/parts.h"
#include "app/teaching/sentences/ends.h"
#include "app/teaching/teaching.h"

#include <algorithm>
#include <array>

namespace app {

namespace {

int endNamed(const SentenceContext& context) { return context.known("i") == 2.0 ? 2 : 1; }

/// The script that the code of both regions selects.
QString script(const SentenceContext& context)
{
    const QString code = words::value(context, "code");
    return Text::tr(
               "Both outcodes together are the number %1, the code of this pair of regions. The "
               "table has a script for each of the 81 pairs.")
               .arg(code)
           + u' '
           + (context.value("code") == 0.0
                  ? Text::tr("The script of this pair is empty: both ends are inside.")
                  : Text::tr(
                      "The script of this pair has only the cuts and tests that the pair needs."));
}

/// A test of the script. If the rounded end is on the edge, the distance that it moved decides.
QString question(const SentenceContext& context)
{
    const int end = endNamed(context);
    const bool mayReject = context.at("notLeft", "notRight", "notBottom", "notTop");
    QString found = words::whetherBeyond(context, end);
    if (context.holds() && !words::isBeyond(context, end, context.edge()))
        found = Text::tr(
                    "%1 lies on %2 after rounding, but the distance that it has moved leads beyond "
                    "that edge")
                    .arg(words::end(end), context.edgeText());
    if (mayReject)
        return context.holds() ? Text::tr("%1, so the line misses the window.").arg(found)
                               : Text::tr("%1: here the line does not miss the window.").arg(found);
    return context.holds() ? Text::tr("%1: it has to move once more.").arg(found)
                           : Text::tr("%1, so it need not move again.").arg(found);
}

QString tested(const SentenceContext& context)
{
    if (context.at("beyond"))
        return context.holds()
                   ? Text::tr("The table has × for this pair: both ends lie beyond one edge.")
                   : Text::tr("The table has no × for this pair: the line may meet the "
                              "window.");
    if (context.at("outside"))
        return context.holds() ? Text::tr("The script is not empty: it moves an end.")
                               : Text::tr("The script is empty: no end has to move.");
    return question(context);
}

/// Where an end would arrive at an edge, before it is clamped.
QString arrival(const SentenceContext& context)
{
    const int end = endNamed(context);
    const auto& line = context.tracedLine.line;
    const QString name = context.step.name == "x" ? QStringLiteral("x") : QStringLiteral("y");
    return words::way(context, words::end(end), end == 1 ? line.a : line.b,
                      context.value(end == 1 ? "way[1]" : "way[2]").value_or(0))
           + u' ' + Text::tr("There %1 = %2.").arg(name, words::value(context, context.step.name));
}

/// Whether rounding has put an end beyond an edge of the other axis.
QString sobkowHeld(const SentenceContext& context)
{
    const bool isLow = context.at("lowAtLeft", "lowAtRight", "lowAtBottom", "lowAtTop");
    const auto axis = 1 - clipping::axisOf(context.edge());
    const auto side = isLow ? clipping::lowerEdge(axis) : clipping::upperEdge(axis);
    const auto name = context.step.name;
    const auto& values = context.before->values;
    const auto before = std::ranges::find(values, name, &clipping::NamedValue::name);
    const bool stays = before != values.end() && before->value == context.value(name);
    return (stays ? Text::tr("Rounding does not put %1 %2: %3 stays.")
                  : Text::tr("Rounding would put %1 %2: %3 is held at the edge."))
        .arg(words::end(endNamed(context)), words::beyond(side, context.tracedLine.y),
             name == "x" ? QStringLiteral("x") : QStringLiteral("y"));
}

QString sobkowGiven(const SentenceContext& context)
{
    const auto& name = context.step.name;
    if (name == "code2")
        return words::outcodes(context);
    if (name == "code")
        return script(context);
    if (name == "dy")
        return Text::tr("From End 1 to End 2, x changes by %1 and y by %2.")
            .arg(words::value(context, "dx"), words::value(context, "dy"));
    return context.at("wayToLeft", "wayToRight", "wayToBottom", "wayToTop") ? arrival(context)
                                                                            : sobkowHeld(context);
}

QString sobkowCut(const SentenceContext& context)
{
    const int end = endNamed(context);
    return Text::tr("%1 is beyond %2, so it moves along the line to that edge, to %3.")
        .arg(words::end(end), context.edgeText(), words::point(words::endOf(end, context)));
}

QString sobkowSentence(const SentenceContext& context)
{
    switch (context.step.what) {
    case clipping::What::Test:
        return tested(context);
    case clipping::What::Cut:
        return sobkowCut(context);
    case clipping::What::Reject:
        return context.at("reject")
                   ? words::bothBeyond(context)
                   : Text::tr("The line passes a corner outside the window: nothing is visible.")
                         + words::lost(context);
    case clipping::What::Accept:
        return words::acceptedIfInside(context);
    default:
        return sobkowGiven(context);
    }
}

constexpr auto sobkowVariables = std::to_array<VariableUnit>({
    {"way[1]", ValueUnit::Length},
    {"way[2]", ValueUnit::Length},
});

} // namespace

extern const Teaching sobkowPospisilYangTeaching;
const Teaching sobkowPospisilYangTeaching{
    .key = "sobkow-pospisil-yang",
    .sentence = sobkowSentence,
    .overlay = scriptOverlay,
    .figure = {.line = {{-150, 40}, {20, -120}}},
    .variables = sobkowVariables,
};

} // namespace app
