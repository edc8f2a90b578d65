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

constexpr words::PartNames cyrusBeckPart{"tE", "tL"};

/// The tests at one edge.
QString cyrusBeckAsked(const SentenceContext& context)
{
    const QString edge = context.edgeText();
    if (context.at("parallel"))
        return (context.holds()
                    ? Text::tr("D = %2: the line is parallel to %1 and never crosses it.")
                    : Text::tr("D = %2 is not 0: the infinite line through both ends crosses "
                               "the line of %1."))
            .arg(edge, knownNumber(context, "D"));
    if (context.at("outside"))
        return (context.holds()
                    ? Text::tr(
                        "The line is parallel to %1 and lies beyond it (N = %2 is less than 0).")
                    : Text::tr(
                        "End 1 is not beyond %1 (N = %2 is not less than 0), so no point of the "
                        "line is: this edge cuts nothing off."))
            .arg(edge, knownNumber(context, "N"));
    if (context.at("entering"))
        return (context.holds() ? Text::tr("D = %1 is greater than 0: at %2 the line enters.")
                                : Text::tr("D = %1 is less than 0: at %2 the line leaves."))
            .arg(knownNumber(context, "D"), edge);
    if (context.at("later"))
        return (context.holds()
                    ? Text::tr("Of all entries so far, the one at %1 is the last (%2).")
                    : Text::tr("The entry at %1 is not after the start of the remaining part "
                               "(%2): this edge cuts nothing off."))
            .arg(edge, knownCompared(context, "t", "tE"));
    return (context.holds() ? Text::tr("Of all exits so far, the one at %1 is the first (%2).")
                            : Text::tr("The exit at %1 is not before the end of the remaining part "
                                       "(%2): this edge cuts nothing off."))
        .arg(edge, knownCompared(context, "t", "tL"));
}

/// The test of the remaining part after all edges.
QString concluded(const SentenceContext& context)
{
    if (context.holds())
        return Text::tr("The line leaves before it enters (tE > tL: %1).")
            .arg(knownCompared(context, "tE", "tL"));
    return Text::tr(
               "The last entry comes no later than the first exit (tE = %1, tL = %2): the part "
               "between them is visible.")
        .arg(knownNumber(context, "tE"), knownNumber(context, "tL"));
}

/// The assignment of a variable at an edge.
QString cyrusBeckGiven(const SentenceContext& context)
{
    const auto& name = context.step.name;
    const QString edge = context.edgeText();
    const auto normal = [&](const QString& text) {
        return text.arg(edge, knownNumber(context, "nx"), knownNumber(context, "ny"));
    };
    if (name == "ny")
        return normal(Text::tr("The inner normal of %1 is (%2, %3). It is as long as that edge."));
    if (name == "D")
        return normal(Text::tr(
                          "The inner normal of %1 is (%2, %3). Along it, the line advances by D = "
                          "%4 from End 1 to End 2."))
            .arg(knownNumber(context, "D"));
    if (name == "N")
        return Text::tr("Along the same normal, End 1 lies N = %1 inside %2 (N < 0: beyond it).")
            .arg(knownNumber(context, "N"), edge);
    if (name == "t")
        return Text::tr("The line crosses %1 at t = −N/D = %2 (0 is End 1, 1 is End 2).")
            .arg(edge, knownNumber(context, "t"));
    if (name == "tE")
        return Text::tr("The remaining part begins at %1, at tE = %2.")
            .arg(edge, knownNumber(context, "tE"));
    return Text::tr("The remaining part ends at %1, at tL = %2.")
        .arg(edge, knownNumber(context, "tL"));
}

QString cyrusBeckAccepted(const SentenceContext& context)
{
    const auto& [a, b] = context.step.segment;
    const auto& window = context.tracedLine.window;
    const bool flat = window.min.x == window.max.x || window.min.y == window.max.y;
    if (flat && (words::isOutside(a, window) || words::isOutside(b, window)))
        return Text::tr(
            "The window has no area, so two of its normals are (0, 0) and cut nothing. The "
            "remaining part is accepted, and that is wrong: it reaches beyond the window.");
    return words::acceptedIfInside(context);
}

QString cyrusBeckSentence(const SentenceContext& context)
{
    const auto what = context.step.what;
    if (what == clipping::What::Accept)
        return cyrusBeckAccepted(context);
    if (what == clipping::What::Reject)
        return Text::tr("Nothing of the line is visible.") + words::lost(context);
    if (words::isEndOfPart(context))
        return words::endsOfPart(context, cyrusBeckPart);
    if (what == clipping::What::Let)
        return context.edge() == clipping::Edge::NoEdge ? words::wholeLine(context, cyrusBeckPart)
                                                        : cyrusBeckGiven(context);
    return context.at("missed") ? concluded(context) : cyrusBeckAsked(context);
}

constexpr auto cyrusBeckVariables = std::to_array<VariableUnit>({
    {"D", ValueUnit::Length},
    {"N", ValueUnit::Length},
    {"nx", ValueUnit::Bare},
    {"ny", ValueUnit::Bare},
    {"tE", ValueUnit::Bare},
    {"tL", ValueUnit::Bare},
    {"xv", ValueUnit::X},
    {"yv", ValueUnit::Y},
    {"xw", ValueUnit::X},
    {"yw", ValueUnit::Y},
});
/// The normals of the published form are as long as the edges.
constexpr auto cyrusBeckPublishedVariables = std::to_array<VariableUnit>({
    {"nx", ValueUnit::Length},
    {"ny", ValueUnit::Length},
    {"D", ValueUnit::Area},
    {"N", ValueUnit::Area},
});

} // namespace

extern const Teaching cyrusBeckTeaching;
const Teaching cyrusBeckTeaching{
    .key = "cyrus-beck",
    .sentence = cyrusBeckSentence,
    .parameter = "t",
    .overlay = parameterOverlay,
    .variables = cyrusBeckVariables,
    .published = cyrusBeckPublishedVariables,
};

} // namespace app
