// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/overlays/parts.h"
#include "app/teaching/sentences/ends.h"
#include "app/teaching/teaching.h"

#include <array>
#include <cmath>

namespace app {

namespace {

/// Whether the line is vertical, horizontal, or a point.
QString kodituwakkuDirection(const SentenceContext& context)
{
    const auto& [a, b] = context.tracedLine.line;
    if (context.at("notUpright"))
        return context.holds()
                   ? Text::tr("The line is not vertical (%1).").arg(words::compared(a.x, b.x))
                   : Text::tr("The line is vertical (x1 = x2 = %1): it has no slope.")
                         .arg(words::number(a.x));
    if (context.at("notLevel"))
        return context.holds()
                   ? Text::tr("The line is not horizontal (%1).").arg(words::compared(a.y, b.y))
                   : Text::tr("The line is horizontal (y1 = y2 = %1).").arg(words::number(a.y));
    return context.holds()
               ? Text::tr("Both ends are the same point, %1.").arg(words::point(a))
               : Text::tr("The two ends are different points (%1).").arg(words::compared(a.y, b.y));
}

QString point(const SentenceContext& context)
{
    return (context.holds() ? Text::tr("The point %1 counts as outside.")
                            : Text::tr("The point %1 is inside."))
        .arg(words::point(context.tracedLine.line.a));
}

/// Whether a horizontal or vertical line lies between the two edges parallel to it: axis 0 for a
/// vertical line, because its x is tested.
QString between(const SentenceContext& context, glm::length_t axis)
{
    const auto& a = context.tracedLine.line.a;
    const auto& [min, max] = context.tracedLine.window;
    const QString ground = axis == 0 ? Text::tr("x1 = %1, xmin = %2, xmax = %3")
                                     : Text::tr("y1 = %1, ymin = %2, ymax = %3");
    const QString numbers =
        ground.arg(words::number(a[axis]), words::number(min[axis]), words::number(max[axis]));
    if (!context.holds())
        return Text::tr("The line lies between the two edges that are parallel to it (%1).")
            .arg(numbers);
    const bool onEdge = a[axis] == min[axis] || a[axis] == max[axis];
    return onEdge ? Text::tr(
                        "The line lies on an edge (%1). The published form counts that as outside.")
                        .arg(numbers)
                  : Text::tr("The line lies outside, beside the window (%1).").arg(numbers);
}

QString tooShort(const SentenceContext& context, glm::length_t axis)
{
    const auto& [a, b] = context.step.segment;
    const double length = std::abs(a[axis] - b[axis]);
    const QString name =
        axis == 0 ? QStringLiteral("|x1 \u2212 x2|") : QStringLiteral("|y1 \u2212 y2|");
    if (std::isnan(length))
        return Text::tr("Now %1 is NaN. Every comparison with NaN is false, so the line is drawn.")
            .arg(name);
    return context.holds()
               ? Text::tr(
                     "Now %1 = %2, less than 1. The published form concludes that the line has "
                     "shrunk to a point and misses the window.")
                     .arg(name, words::number(length))
               : Text::tr("Now %1 = %2, not less than 1: the line has not shrunk to a "
                          "point, so it meets "
                          "the window.")
                     .arg(name, words::number(length));
}

/// Whether an end must be moved to the step's edge.
QString push(const SentenceContext& context, int number)
{
    if (words::asksTheWay(context))
        return words::whetherPassed(context, number);
    return context.holds() ? Text::tr("%1, so it is pushed to %2.")
                                 .arg(words::whetherBeyond(context, number), context.edgeText())
                           : Text::tr("%1.").arg(words::whetherBeyond(context, number));
}

/// Whether the other end is beyond the same edge at its original place.
QString other(const SentenceContext& context)
{
    const QString where = words::beyond(context.edge(), context.tracedLine.y);
    return context.holds()
               ? Text::tr("The other end lies %1 too.").arg(where)
               : Text::tr("The other end does not lie %1, so %2 does not rule the line out.")
                     .arg(where, context.edgeText());
}

QString kodituwakkuTest(const SentenceContext& context, int number)
{
    if (context.at("notUpright", "notLevel", "point"))
        return kodituwakkuDirection(context);
    if (context.at("short", "levelShort"))
        return tooShort(context, 0);
    if (context.at("uprightShort"))
        return tooShort(context, 1);
    if (context.at("levelOutside"))
        return between(context, 1);
    if (context.at("uprightOutside"))
        return between(context, 0);
    if (context.at("pointOutside"))
        return point(context);
    if (context.at("bothLeft", "bothRight", "bothBelow", "bothAbove", "levelBothLeft",
                   "levelBothRight", "uprightBothBelow", "uprightBothAbove"))
        return other(context);
    return push(context, number);
}

/// The new value of a variable.
QString kodituwakkuGiven(const SentenceContext& context, int number)
{
    const auto& name = context.step.name;
    const auto& [a, b] = context.tracedLine.line;
    const Point& end = number == 1 ? a : b;
    if (name == "m")
        return Text::tr("The slope of the line is m = %1.").arg(words::value(context, "m"));
    if (name == "c")
        return Text::tr("The line meets the y axis at c = %1. From now on the line is y = mx + c.")
            .arg(words::value(context, "c"));
    if (name == "dy")
        return Text::tr("The slope stays a fraction, dy = %2 over dx = %1, so that no quotient is "
                        "rounded yet.")
            .arg(words::value(context, "dx"), words::value(context, "dy"));
    if (name == "left")
        return words::held(context);
    if (name == "rise" || name == "run")
        return words::way(context, words::end(number), end, context.value(name).value_or(0));
    return Text::tr("%1 is originally at %2, the other end at %3.")
        .arg(words::end(number), words::point(end), words::point(number == 1 ? b : a));
}

QString kodituwakkuRejected(const SentenceContext& context)
{
    return words::isPublished(context)
               ? Text::tr("The line is rejected: the published form draws nothing.")
                     + words::lost(context)
               : words::bothBeyond(context);
}

QString kodituwakkuSentence(const SentenceContext& context)
{
    const int number = int(context.known("i").value_or(1));
    switch (context.step.what) {
    case clipping::What::Test:
        return kodituwakkuTest(context, number);
    case clipping::What::Cut:
        return words::moved(context, number);
    case clipping::What::Reject:
        return kodituwakkuRejected(context);
    case clipping::What::Accept:
        return words::acceptedIfInside(context);
    default:
        return kodituwakkuGiven(context, number);
    }
}

/// The variables of the line y = mx + c.
constexpr auto kodituwakkuVariables = std::to_array<VariableUnit>({
    {"m", ValueUnit::Bare},
    {"c", ValueUnit::FixedLength},
});

} // namespace

extern const Teaching kodituwakkuWijeweeraChamikaraTeaching;
const Teaching kodituwakkuWijeweeraChamikaraTeaching{
    .key = "kodituwakku-wijeweera-chamikara",
    .sentence = kodituwakkuSentence,
    .overlay = pushOverlay,
    .figure = {.line = {{-150, -110}, {120, 100}}},
    .variables = kodituwakkuVariables,
};

} // namespace app
