// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/overlays/parts.h"
#include "app/teaching/sentences/ends.h"
#include "app/teaching/sentences/words.h"
#include "app/teaching/teaching.h"

namespace app {

using clipping::Edge;

namespace {

/// Whether both ends are beyond the same edge of an axis.
QString matthesBothBeyond(const SentenceContext& context)
{
    const auto &a = context.step.segment.a, &b = context.step.segment.b;
    const auto& window = context.tracedLine.window;
    if (context.holds())
        return Text::tr("Both ends lie %1: %2 and %3.")
            .arg(words::beyond(context.edge(), context.tracedLine.y),
                 words::compared(a, context.edge(), window),
                 words::compared(b, context.edge(), window));
    const int axis = context.at("besideY") ? 1 : 0;
    const auto numbers = [&](const QString& text) {
        return text.arg(words::number(a[axis]), words::number(b[axis]),
                        words::number(window.min[axis]), words::number(window.max[axis]));
    };
    return axis == 0
               ? numbers(Text::tr("From x = %1 to x = %2 the line lies neither wholly left nor "
                                  "wholly right of the window (%3 to %4): x does not rule it out."))
               : numbers(Text::tr("From y = %1 to y = %2 the line lies neither wholly above nor "
                                  "wholly below the window (%3 to %4): y does not rule it out."));
}

/// Whether one end is beyond an edge.
QString matthesOneBeyond(const SentenceContext& context, int number)
{
    const Edge edge = context.edge();
    const auto& p = number == 1 ? context.step.segment.a : context.step.segment.b;
    if (words::asksTheWay(context))
        return words::whetherPassed(context, number);
    const QString where = words::beyond(edge, context.tracedLine.y), end = words::end(number);
    const QString numbers = words::compared(p, edge, context.tracedLine.window);
    return (context.holds() ? Text::tr("%1 lies %2 (%3), so it has to move along the line to %4.")
                            : Text::tr("%1 does not lie %2 (%3), so %4 does not cut it."))
        .arg(end, where, numbers, context.edgeText());
}

/// How far the line goes along the other axis on its way to the edge.
QString wayTo(const SentenceContext& context, int number)
{
    const int from = words::isPublished(context) ? 1 : number;
    const auto& line = context.tracedLine.line;
    const auto [dx, dy] = std::pair(line.b.x - line.a.x, line.b.y - line.a.y);
    const double slope = context.step.name == "rise" ? dy / dx : dx / dy;
    return words::way(context, words::end(from), from == 1 ? line.a : line.b,
                      context.value(context.step.name).value_or(0),
                      words::isPublished(context) ? std::optional(slope) : std::nullopt);
}

/// The numbers of a formula as it was misprinted, and what the pseudo-code computes.
QString misprinted(const SentenceContext& context)
{
    const auto& line = context.tracedLine.line;
    const auto [dx, dy] = std::pair(line.b.x - line.a.x, line.b.y - line.a.y);
    const glm::length_t along = clipping::axisOf(context.edge());
    const double away =
        clipping::levelOf(context.edge(), context.tracedLine.window) - line.a[along];
    const double meant = (along == 0 ? dy / dx : dx / dy) * away;
    const QString numbers = generalSentence(context);
    if (meant == context.value(context.step.name))
        return numbers;
    return Text::tr("%1 This is the misprint: as meant, %2 = %3.")
        .arg(numbers, latin(context.step.name), words::number(meant));
}

/// After both axes, only x can still be outside, and only if the line misses the window.
QString stillBeyond(const SentenceContext& context)
{
    const auto &a = context.step.segment.a, &b = context.step.segment.b;
    const auto& window = context.tracedLine.window;
    if (context.holds())
        return Text::tr(
                   "Both ends now lie %1 (%2 and %3): the algorithm concludes that the line misses "
                   "the window.")
            .arg(words::beyond(context.edge(), context.tracedLine.y),
                 words::compared(a, context.edge(), window),
                 words::compared(b, context.edge(), window));
    return Text::tr(
               "The ends are now at x = %1 and x = %2, neither both left nor both right of the "
               "window: the algorithm concludes that the line meets it.")
        .arg(words::number(a.x), words::number(b.x));
}

QString matthesRejected(const SentenceContext& context)
{
    if (context.at("reject"))
        return Text::tr(
            "If the line met the window, its ends would lie in the window now. So nothing is "
            "visible.");
    return Text::tr(
               "Both ends lie %1, and so does every point between them: nothing of the line is "
               "visible.")
        .arg(words::beyond(context.edge(), context.tracedLine.y));
}

QString matthesAccepted(const SentenceContext& context)
{
    const auto& [a, b] = context.step.segment;
    const auto& window = context.tracedLine.window;
    if (words::isOutside(a, window) || words::isOutside(b, window))
        return Text::tr(
                   "%1 lies outside the window, at %2. The last test finds only ends that are both "
                   "left or both right of the window, so the line is drawn: this is wrong.")
            .arg(words::end(words::isOutside(a, window) ? 1 : 2),
                 words::point(words::isOutside(a, window) ? a : b));
    return words::acceptedIfInside(context);
}

QString matthesSentence(const SentenceContext& context)
{
    const auto what = context.step.what;
    const auto& name = context.step.name;
    const int number = int(context.known("i").value_or(1));
    const bool isMisprint = context.tracedLine.variant.misprint != nullptr;
    if (what == clipping::What::Accept)
        return matthesAccepted(context);
    if (what == clipping::What::Reject)
        return matthesRejected(context) + words::lost(context);
    if (what == clipping::What::Cut)
        return isMisprint ? generalSentence(context) : words::moved(context, number);
    if (name == "dy")
        return Text::tr("From End 1 to End 2, x changes by %1 and y by %2.")
            .arg(words::value(context, "dx"), words::value(context, "dy"));
    if (name == "moved")
        return Text::tr("%1 starts at its original place, %2: it has not been moved yet.")
            .arg(words::end(number),
                 words::point(number == 1 ? context.step.segment.a : context.step.segment.b));
    if (name == "left")
        return words::held(context);
    if (name == "rise" || name == "run")
        return isMisprint ? misprinted(context) : wayTo(context, number);
    if (context.at("besideX", "besideY"))
        return matthesBothBeyond(context);
    return context.at("missed") ? stillBeyond(context) : matthesOneBeyond(context, number);
}

} // namespace

extern const Teaching matthesDrakopoulosTeaching;
const Teaching matthesDrakopoulosTeaching{
    .key = "matthes-drakopoulos",
    .sentence = matthesSentence,
    .overlay = pushOverlay,
};

} // namespace app
