// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/overlays/parts.h"
#include "app/teaching/sentences/ends.h"
#include "app/teaching/sentences/words.h"
#include "app/teaching/teaching.h"

#include <cmath>

namespace app {

using clipping::What;

namespace {

unsigned cohenSutherlandKnown(const SentenceContext& context, const char* name)
{
    return unsigned(context.known(name).value_or(0));
}

/// The current outcode of an end.
unsigned codeOf(const SentenceContext& context, int number)
{
    if (words::isPublished(context))
        return cohenSutherlandKnown(context, number == 1 ? "code1" : "code2");
    return cohenSutherlandKnown(context, number == 1 ? "code[1]" : "code[2]");
}

QString cohenSutherlandCodeText(const SentenceContext& context, int number)
{
    return outcodeText(codeOf(context, number));
}
QString cohenSutherlandCodeAndRegion(const SentenceContext& context, int number)
{
    return words::codeAndRegion(codeOf(context, number), context.tracedLine.y);
}

/// The end that is cut: End 1 while it is outside.
int endOutside(const SentenceContext& context)
{
    return words::isPublished(context) ? (codeOf(context, 1) != 0 ? 1 : 2)
                                       : int(cohenSutherlandKnown(context, "i"));
}

QString cohenSutherlandOutcodes(const SentenceContext& context)
{
    return Text::tr("The outcodes say where the ends lie: End 1 has %1, End 2 has %2.")
        .arg(cohenSutherlandCodeAndRegion(context, 1), cohenSutherlandCodeAndRegion(context, 2));
}

/// Whether any end is outside.
QString anyOutside(const SentenceContext& context, bool outside)
{
    const unsigned either = codeOf(context, 1) | codeOf(context, 2);
    return (outside
                ? Text::tr(
                    "At least one end is outside, because %1 | %2 = %3 is not 0000: the line "
                    "cannot be accepted yet.")
                : Text::tr("Both ends are inside, because %1 | %2 = %3: the line can be accepted."))
        .arg(cohenSutherlandCodeText(context, 1), cohenSutherlandCodeText(context, 2),
             outcodeText(either));
}

/// Whether both ends are beyond one edge.
QString cohenSutherlandBothBeyond(const SentenceContext& context)
{
    const unsigned common = codeOf(context, 1) & codeOf(context, 2);
    if (!context.holds())
        return Text::tr("No edge has both ends beyond it, because %1 & %2 = %3: the line cannot be "
                        "rejected yet.")
            .arg(cohenSutherlandCodeText(context, 1), cohenSutherlandCodeText(context, 2),
                 outcodeText(common));
    return Text::tr("Both ends lie %4, because %1 & %2 = %3 is not 0000.")
        .arg(cohenSutherlandCodeText(context, 1), cohenSutherlandCodeText(context, 2),
             outcodeText(common), words::beyond(words::edgeOf(common), context.tracedLine.y));
}

QString cohenSutherlandRejected(const SentenceContext& context)
{
    const unsigned common = codeOf(context, 1) & codeOf(context, 2);
    return Text::tr(
               "Both ends lie %1, and so does every point between them: nothing of the line is "
               "visible.")
        .arg(words::beyond(words::edgeOf(common), context.tracedLine.y));
}

/// Which end is cut next.
QString chosen(const SentenceContext& context)
{
    return codeOf(context, 1) != 0
               ? Text::tr("End 1 is outside, with the outcode %1, so End 1 is cut.")
                     .arg(cohenSutherlandCodeAndRegion(context, 1))
               : Text::tr(
                     "End 1 is inside and End 2 is outside, with the outcode %1, so End 2 is cut.")
                     .arg(cohenSutherlandCodeAndRegion(context, 2));
}

/// Whether the end is cut at the step's edge.
QString cutThere(const SentenceContext& context)
{
    const int number = endOutside(context);
    const QString code = cohenSutherlandCodeText(context, number), end = words::end(number);
    if (!context.holds())
        return Text::tr("The bit of %1 is not set in %2: %3 is not cut at that edge.")
            .arg(context.edgeText(), code, end);
    return Text::tr("The bit of %1 is set in %2: %3 lies %4 and is cut at that edge.")
        .arg(context.edgeText(), code, end, words::beyond(context.edge(), context.tracedLine.y));
}

/// Published form: the point where the line meets the edge.
QString meets(const SentenceContext& context)
{
    const int along = clipping::axisOf(context.edge());
    const auto& window = context.tracedLine.window;
    const double level = clipping::levelOf(context.edge(), window);
    const double there = context.value(along == 0 ? "y" : "x").value_or(0);
    if (!std::isfinite(there))
        return Text::tr("The numbers are too large: their product overflows, %1 becomes %2, and "
                        "everything computed from it is meaningless.")
            .arg(along == 0 ? QStringLiteral("y") : QStringLiteral("x"), words::number(there));
    return Text::tr("From End 1 to %1, %3 changes by %2. There the line is at %4.")
        .arg(context.edgeText(), words::number(level - context.step.segment.a[along]),
             words::axisName(context.edge()),
             words::point(along == 0 ? Point{level, there} : Point{there, level}));
}

/// Corrected form: how far the end moves from its original place.
QString way(const SentenceContext& context)
{
    const int number = endOutside(context);
    const auto& line = context.tracedLine.line;
    return words::way(context, words::end(number), number == 1 ? line.a : line.b,
                      context.value(context.step.name).value_or(0));
}

QString moved(const SentenceContext& context)
{
    if (!words::isPublished(context))
        return words::moved(context, endOutside(context));
    const int number = context.value("code1") ? 1 : 2;
    return words::moved(context, number) + u' '
           + Text::tr("Its outcode is now %1.").arg(cohenSutherlandCodeAndRegion(context, number));
}

/// The corrected form's new outcode, before and after the bits of edges that have cut the end are
/// cleared.
QString newCode(const SentenceContext& context)
{
    const int number = endOutside(context);
    if (context.edge() != clipping::Edge::NoEdge)
        return Text::tr("The distance that %1 has moved, compared with its distances to the other "
                        "edges, gives the outcode %2.")
            .arg(words::end(number), cohenSutherlandCodeAndRegion(context, number));
    const unsigned done = cohenSutherlandKnown(context, number == 1 ? "done[1]" : "done[2]");
    return Text::tr(
               "An edge that has cut %1 does not cut it again. The bits of these edges, %2, are "
               "cleared, so the outcode is %3.")
        .arg(words::end(number), outcodeText(done), cohenSutherlandCodeAndRegion(context, number));
}

/// The tests without an edge.
QString decided(const SentenceContext& context)
{
    if (context.at("inside"))
        return anyOutside(context, !context.holds());
    if (context.at("outside"))
        return anyOutside(context, context.holds());
    if (context.at("beyond"))
        return cohenSutherlandBothBeyond(context);
    return !words::isPublished(context) ? chosen(context)
           : context.holds()            ? Text::tr("The outcode is that of End 1, so End 1 is cut.")
                             : Text::tr("The outcode is not that of End 1, so End 2 is cut.");
}

QString cohenSutherlandSentence(const SentenceContext& context)
{
    const auto what = context.step.what;
    const auto& name = context.step.name;
    if (what == What::Accept)
        return words::acceptedIfInside(context);
    if (what == What::Reject)
        return cohenSutherlandRejected(context) + words::lost(context);
    if (what == What::GiveUp)
        return Text::tr(
            "After 64 cuts the loop still goes on: each cut clears one bit, and rounding "
            "sets another. The published form never ends on this line. It is stopped, and "
            "nothing is drawn.");
    if (what == What::Cut)
        return moved(context);
    if (what == What::Test)
        return context.edge() == clipping::Edge::NoEdge ? decided(context) : cutThere(context);
    if (context.at("codes"))
        return cohenSutherlandOutcodes(context);
    if (name == "left")
        return words::held(context);
    if (name == "codeOut")
        return chosen(context);
    if (name == "i")
        return Text::tr("The cut starts from the original position of %1, %2.")
            .arg(words::end(endOutside(context)),
                 words::point(endOutside(context) == 1 ? context.tracedLine.line.a
                                                       : context.tracedLine.line.b));
    if (name == "x" || name == "y")
        return meets(context);
    return name == "run" || name == "rise" ? way(context) : newCode(context);
}

} // namespace

extern const Teaching cohenSutherlandTeaching;
const Teaching cohenSutherlandTeaching{
    .key = "cohen-sutherland",
    .sentence = cohenSutherlandSentence,
    .overlay = outcodeOverlay,
    .figure = {.line = {{-170, -120}, {130, 60}}}, // an end is cut twice
};

} // namespace app
