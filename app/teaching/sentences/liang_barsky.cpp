// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/overlays/parts.h"
#include "app/teaching/sentences/ends.h"
#include "app/teaching/sentences/part.h"
#include "app/teaching/sentences/words.h"
#include "app/teaching/teaching.h"

#include <array>

namespace app {

namespace {

using words::knownCompared;
using words::knownNumber;

constexpr words::PartNames liangBarskyPart{"u0", "u1"};

/// The direction of the line at one edge.
QString liangBarskyDirection(const SentenceContext& context)
{
    const QString edge = context.edgeText(), p = knownNumber(context, "p");
    if (context.at("beside"))
        return (context.holds()
                    ? Text::tr(
                        "The line is parallel to %1 and lies beyond it (q = %2 is less than 0).")
                    : Text::tr(
                        "End 1 is not beyond %1 (q = %2 is not less than 0), so no point of the "
                        "line is: this edge cuts nothing off."))
            .arg(edge, knownNumber(context, "q"));
    if (context.at("leaving"))
        return (context.holds()
                    ? Text::tr("p = %1 is greater than 0: at %2 the line leaves.")
                    : Text::tr("p = %1: the line is parallel to %2 and never crosses it."))
            .arg(p, edge);
    return (context.holds() ? Text::tr("p = %1 is less than 0: at %2 the line enters.")
                            : Text::tr("p = %1 is not less than 0: at %2 the line does not enter."))
        .arg(p, edge);
}

/// The effect of a crossing.
QString crossing(const SentenceContext& context)
{
    const QString edge = context.edgeText();
    const QString toStop = knownCompared(context, "r", "u1");
    const QString toStart = knownCompared(context, "r", "u0");
    if (context.at("tooLate"))
        return context.holds()
                   ? Text::tr("The entry at %1 comes after the end of the remaining part (%2).")
                         .arg(edge, toStop)
                   : Text::tr(
                         "The entry is not after the end of the remaining part (%1), so something "
                         "may be visible.")
                         .arg(toStop);
    if (context.at("tooEarly"))
        return context.holds()
                   ? Text::tr("The exit at %1 comes before the start of the remaining part (%2).")
                         .arg(edge, toStart)
                   : Text::tr("The exit is not before the start of the remaining part (%1), "
                              "so something "
                              "may be visible.")
                         .arg(toStart);
    if (context.at("later"))
        return (context.holds()
                    ? Text::tr("Of all entries so far, the one at %1 is the last (%2).")
                    : Text::tr("The entry at %1 is not after the start of the remaining part "
                               "(%2): this edge cuts nothing off."))
            .arg(edge, toStart);
    return (context.holds() ? Text::tr("Of all exits so far, the one at %1 is the first (%2).")
                            : Text::tr("The exit at %1 is not before the end of the remaining part "
                                       "(%2): this edge cuts nothing off."))
        .arg(edge, toStop);
}

/// The meaning of the signs of p and q for the line at an edge.
QString liangBarskyAtEdge(const SentenceContext& context)
{
    const double p = context.known("p").value_or(0), q = context.known("q").value_or(0);
    const QString way = p < 0   ? Text::tr("At %1, p = %2 < 0: the line enters.")
                        : p > 0 ? Text::tr("At %1, p = %2 > 0: the line leaves.")
                                : Text::tr("At %1, p = %2: the line is parallel to it.");
    return way.arg(context.edgeText(), words::number(p)) + u' '
           + (q < 0 ? Text::tr("q = %1 < 0: End 1 is beyond that edge.")
                    : Text::tr("q = %1: End 1 is not beyond that edge."))
                 .arg(words::number(q));
}

/// The assignment of a variable at an edge, in `clipt` or at its calls.
QString liangBarskyGiven(const SentenceContext& context)
{
    const auto& name = context.step.name;
    const QString edge = context.edgeText();
    if (name == "q")
        return liangBarskyAtEdge(context);
    if (name == "u0")
        return Text::tr("The remaining part begins at %1, at u0 = %2.")
            .arg(edge, knownNumber(context, "u0"));
    if (name == "u1")
        return Text::tr("The remaining part ends at %1, at u1 = %2.")
            .arg(edge, knownNumber(context, "u1"));
    return (context.at("entry")
                ? Text::tr("The line enters across %1 at r = q/p = %2 (0 is End 1, 1 is End 2).")
                : Text::tr("The line leaves across %1 at r = q/p = %2 (0 is End 1, 1 is End 2)."))
        .arg(edge, knownNumber(context, "r"));
}

QString liangBarskySentence(const SentenceContext& context)
{
    const auto what = context.step.what;
    if (what == clipping::What::Accept)
        return words::acceptedIfInside(context);
    if (what == clipping::What::Reject)
        return Text::tr("Nothing of the line is visible.") + words::lost(context);
    if (words::isEndOfPart(context))
        return words::endsOfPart(context, liangBarskyPart);
    if (what == clipping::What::Let)
        return context.edge() == clipping::Edge::NoEdge ? words::wholeLine(context, liangBarskyPart)
                                                        : liangBarskyGiven(context);
    return context.at("entering", "leaving", "beside") ? liangBarskyDirection(context)
                                                       : crossing(context);
}

constexpr auto liangBarskyVariables = std::to_array<VariableUnit>({
    {"p", ValueUnit::Length},
    {"q", ValueUnit::Length},
    {"r", ValueUnit::Bare},
    {"u0", ValueUnit::Bare},
    {"u1", ValueUnit::Bare},
});

} // namespace

extern const Teaching liangBarskyTeaching;
const Teaching liangBarskyTeaching{
    .key = "liang-barsky",
    .sentence = liangBarskySentence,
    .parameter = "r",
    .overlay = parameterOverlay,
    .figure = {.mark = Mark::Divide}, // a parameter and its place on the line
    .variables = liangBarskyVariables,
};

} // namespace app
