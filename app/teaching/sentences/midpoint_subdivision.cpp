// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/overlays/parts.h"
#include "app/teaching/sentences/ends.h"
#include "app/teaching/sentences/words.h"
#include "app/teaching/teaching.h"

#include <array>

namespace app {

using clipping::What;

namespace {

unsigned bitsOf(const SentenceContext& context, const char* name)
{
    return unsigned(context.known(name).value_or(0));
}
QString midpointCodeText(const SentenceContext& context, const char* name)
{
    return outcodeText(bitsOf(context, name));
}
QString midpointCodeAndRegion(const SentenceContext& context, const char* name)
{
    return words::codeAndRegion(bitsOf(context, name), context.tracedLine.y);
}
QString numberOf(const SentenceContext& context, const char* name)
{
    return words::number(context.known(name).value_or(0));
}

QString midpointOutcodes(const SentenceContext& context)
{
    return Text::tr("The outcodes say where the ends lie: End 1 has %1, End 2 has %2.")
        .arg(midpointCodeAndRegion(context, "code1"), midpointCodeAndRegion(context, "code2"));
}

/// A common bit of two outcodes, as an edge that both points lie beyond.
QString beyondBoth(const SentenceContext& context, const char* one, const char* other)
{
    return words::beyond(words::edgeOf(bitsOf(context, one) & bitsOf(context, other)),
                         context.tracedLine.y);
}

/// Line 2: whether both ends are beyond the same edge.
QString midpointBothBeyond(const SentenceContext& context)
{
    const QString one = midpointCodeText(context, "code1"),
                  two = midpointCodeText(context, "code2");
    return context.holds()
               ? Text::tr("Both ends lie %3, because %1 & %2 is not 0000.")
                     .arg(one, two, beyondBoth(context, "code1", "code2"))
               : Text::tr("No edge has both ends beyond it, because %1 & %2 = 0000: the line "
                          "may meet the window.")
                     .arg(one, two);
}

/// Whether an end is outside, so that a search for it is needed.
QString sought(const SentenceContext& context, int number)
{
    const QString code = midpointCodeText(context, number == 1 ? "code1" : "code2");
    if (context.holds())
        return Text::tr("%1 is outside (%2): halving searches for the visible point nearest to it.")
            .arg(words::end(number), code);
    return number == 1 && context.known("contact") == 1.0
               ? Text::tr("The line meets the window in one point, which has been found.")
               : Text::tr("%1 is inside (%2) and stays.").arg(words::end(number), code);
}

/// Whether the near and the far point share a bit.
QString midpointNearAndFar(const SentenceContext& context, bool share)
{
    const QString near = midpointCodeText(context, "near"), far = midpointCodeText(context, "far");
    return share ? Text::tr("The near point (%1) and the far point (%2) both lie %3.")
                       .arg(near, far, beyondBoth(context, "near", "far"))
                 : Text::tr(
                       "The near point (%1) and the far point (%2) have no bit in common: the end "
                       "that is sought lies between them.")
                       .arg(near, far);
}

/// Which half is discarded.
QString halved(const SentenceContext& context)
{
    const QString code = midpointCodeAndRegion(context, "M");
    return (context.holds()
                ? Text::tr(
                    "The midpoint, with the outcode %1, and the far point lie beyond the same "
                    "edge: the half between them is invisible and is dropped.")
                : Text::tr(
                    "The midpoint, with the outcode %1, has no bit in common with the far point: "
                    "the end that is sought lies between them, in the far half."))
        .arg(code);
}

QString midpointRejected(const SentenceContext& context)
{
    if (context.at("rejectBeyond"))
        return Text::tr(
                   "Both ends lie %1, and so does every point between them: nothing of the line is "
                   "visible.")
            .arg(beyondBoth(context, "code1", "code2"));
    if (context.at("rejectNear"))
        return Text::tr(
            "There is nothing left to halve, and the near point is still outside: nothing is "
            "visible.");
    return Text::tr("Both points lie %1, and so does every point between them: nothing is visible.")
        .arg(beyondBoth(context, "near", "far"));
}

/// The result of the search for an end.
QString found(const SentenceContext& context)
{
    const int number = context.at("move2", "contact1") ? 2 : 1;
    if (context.at("contact1", "contact2"))
        return Text::tr("%1 is at the same point.").arg(words::end(number));
    return Text::tr("There is nothing left to halve: %1 is found at %2, on %3.")
        .arg(words::end(number), words::point(words::endOf(number, context)), context.edgeText());
}

QString searchTest(const SentenceContext& context)
{
    if (context.at("bothBeyond"))
        return midpointNearAndFar(context, context.holds());
    if (context.at("goOn"))
        return context.holds() || (bitsOf(context, "near") & bitsOf(context, "far")) != 0
                   ? midpointNearAndFar(context, !context.holds())
                   : Text::tr("After %1 halvings nothing is left to halve.")
                         .arg(numberOf(context, "halvings"));
    if (context.at("noneLeft"))
        return context.holds()
                   ? Text::tr(
                       "The midpoint is one of the two points: there is nothing left to halve.")
                   : Text::tr(
                       "The midpoint lies between the two points and halves the line between "
                       "them.");
    if (context.at("nearOutside"))
        return context.holds()
                   ? Text::tr("The near point is still outside, with the outcode %1.")
                         .arg(midpointCodeAndRegion(context, "near"))
                   : Text::tr("The near point is inside: it is the end that was sought.");
    return halved(context);
}

QString midpointTest(const SentenceContext& context)
{
    if (context.at("beyond"))
        return midpointBothBeyond(context);
    if (context.at("outside"))
        return context.holds() ? Text::tr("At least one end is outside: the line has to be halved.")
                               : Text::tr("Both ends are inside: there is nothing to search for.");
    if (context.at("end2"))
        return sought(context, 2);
    if (context.at("end1"))
        return sought(context, 1);
    if (context.at("touches2"))
        return context.holds()
                   ? Text::tr("The near point (%1) and the far point (%2) are both outside, "
                              "but beyond different edges: the window lies between them, and "
                              "the line meets it in one point.")
                         .arg(midpointCodeText(context, "near"), midpointCodeText(context, "far"))
                   : Text::tr("The near point is inside: it is the end that was sought.");
    if (context.at("onePoint"))
        return context.holds()
                   ? Text::tr(
                       "The two ends are at most 2⁻⁵³ of the line apart: they count as one point.")
                   : Text::tr("The two ends are different points: more than one point is visible.");
    if (context.at("isContact"))
        return context.holds() ? Text::tr("The line meets the window in one point.")
                               : Text::tr("The line meets the window in more than one point.");
    return searchTest(context);
}

/// The assignment of a variable.
QString midpointGiven(const SentenceContext& context)
{
    const auto& name = context.step.name;
    if (context.at("codes"))
        return midpointOutcodes(context);
    if (name == "ym")
        return Text::tr("The midpoint between the near and the far point is %1.")
            .arg(words::point({context.known("xm").value_or(0), context.known("ym").value_or(0)}));
    if (name == "M")
        return Text::tr("The outcode of the midpoint is %1.")
            .arg(midpointCodeAndRegion(context, "M"));
    if (name == "contact")
        return context.at("contact")
                   ? Text::tr("So far, the line is not known to meet the window in only one point.")
               : context.known("contact") == 1.0
                   ? Text::tr(
                       "The near point is outside as well: the line meets the window in one point.")
                   : Text::tr("The near point is inside: it is the end that was sought.");
    if (name == "toRight" || name == "toTop")
        return name == "toRight"
                   ? Text::tr(
                         "Measured from End 1 in x, End 2 is at %1, xmin at %2 and xmax at %3.")
                         .arg(numberOf(context, "dx"), numberOf(context, "toLeft"),
                              numberOf(context, "toRight"))
                   : Text::tr(
                         "Measured from End 1 in y, End 2 is at %1, ymin at %2 and ymax at %3.")
                         .arg(numberOf(context, "dy"), numberOf(context, "toBottom"),
                              numberOf(context, "toTop"));
    if (name == "halvings")
        return context.value("t")
                   ? Text::tr("The midpoint lies at t = %1 (0 is End 1, 1 is End 2).")
                         .arg(numberOf(context, "t"))
                   : Text::tr("Nothing has been halved yet.");
    if (name == "s")
        return Text::tr("The end lies at t = %1, on each edge whose bit is set in %2.")
            .arg(numberOf(context, "t"), midpointCodeText(context, "s"));
    if (name == "x" || name == "y")
        return context.value("x") && context.value("y")
                   ? Text::tr("There the line is at %1.")
                         .arg(words::point(
                             {context.known("x").value_or(0), context.known("y").value_or(0)}))
                   : Text::tr("On its edge, or held inside the window, %1 is %2.")
                         .arg(QLatin1StringView(name.data(), qsizetype(name.size())),
                              words::number(context.value(name).value_or(0)));
    if (context.value("near") && context.value("far"))
        return Text::tr("The near point has the outcode %1, the far point %2.")
            .arg(midpointCodeAndRegion(context, "near"), midpointCodeAndRegion(context, "far"));
    return name == "far" ? Text::tr("The midpoint, with the outcode %1, becomes the far point.")
                               .arg(midpointCodeAndRegion(context, "far"))
                         : Text::tr("The midpoint, with the outcode %1, becomes the near point.")
                               .arg(midpointCodeAndRegion(context, "near"));
}

QString midpointSentence(const SentenceContext& context)
{
    switch (context.step.what) {
    case What::Accept:
        return words::acceptedIfInside(context);
    case What::Reject:
        return midpointRejected(context) + words::lost(context);
    case What::GiveUp:
        return Text::tr(
            "The halving never ends with these numbers: it is stopped, and nothing is visible.");
    case What::Cut:
        return found(context);
    case What::Test:
        return midpointTest(context);
    default:
        return midpointGiven(context);
    }
}

constexpr auto midpointVariables = std::to_array<VariableUnit>({
    {"f", ValueUnit::Bare},
    {"last", ValueUnit::Bare},
    {"n", ValueUnit::Bare},
    {"q", ValueUnit::Length},
    {"toLeft", ValueUnit::Length},
    {"toRight", ValueUnit::Length},
    {"toBottom", ValueUnit::Length},
    {"toTop", ValueUnit::Length},
    {"xf", ValueUnit::X},
    {"yf", ValueUnit::Y},
    {"xm", ValueUnit::X},
    {"ym", ValueUnit::Y},
    {"xn", ValueUnit::X},
    {"yn", ValueUnit::Y},
});

} // namespace

extern const Teaching midpointSubdivisionTeaching;
const Teaching midpointSubdivisionTeaching{
    .key = "midpoint-subdivision",
    .sentence = midpointSentence,
    .parameter = "t",
    .middle = {"xm", "ym"},
    .overlay = midpointOverlay,
    .figure = {.line = {{-40, -10}, {160, 110}}}, // halves without division
    .variables = midpointVariables,
};

} // namespace app
