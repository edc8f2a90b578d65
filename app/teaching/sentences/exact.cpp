// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/overlays/half_plane.h"
#include "app/overlays/parts.h"
#include "app/teaching/sentences/words.h"
#include "app/teaching/teaching.h"

#include <array>

namespace app {

using clipping::Edge;

namespace {

/// An end of the line, and the edges that the line crosses near it.
struct Side {
    Edge x, y;             ///< the edges that the line passes there
    bool beyondX, beyondY; ///< whether the end lies beyond them
};

Side sideOf(const Point& p, Edge x, Edge y, const clipping::Window& w)
{
    return {x, y, isBeyond(p, x, w), isBeyond(p, y, w)};
}
Side entryOf(const TracedLine& tracedLine)
{
    const auto& [a, b] = tracedLine.line;
    return sideOf(a, a.x < b.x ? Edge::Left : Edge::Right, a.y < b.y ? Edge::Bottom : Edge::Top,
                  tracedLine.window);
}
Side exitOf(const TracedLine& tracedLine)
{
    const auto& [a, b] = tracedLine.line;
    return sideOf(b, a.x < b.x ? Edge::Right : Edge::Left, a.y < b.y ? Edge::Top : Edge::Bottom,
                  tracedLine.window);
}

/// Whether both ends are beyond the same edge of an axis.
QString exactBothBeyond(const SentenceContext& context)
{
    const auto axis = context.at("besideX") ? 0 : 1;
    const auto beyond = [&](Edge edge) { return words::beyond(edge, context.tracedLine.y); };
    if (context.holds())
        return Text::tr("Both ends lie %1, and so does every point between them.")
            .arg(beyond(context.edge()));
    return Text::tr("The ends lie neither both %1 nor both %2: the line may meet the window.")
        .arg(beyond(clipping::lowerEdge(axis)), beyond(clipping::upperEdge(axis)));
}

/// The direction of the line.
QString exactDirection(const SentenceContext& context)
{
    const auto& [a, b] = context.tracedLine.line;
    const auto grows = [&](const char* name) {
        return context.value(name) == 1.0 ? Text::tr("grows") : Text::tr("does not grow");
    };
    return Text::tr("From End 1 to End 2, x %1 (%2) and y %3 (%4).")
        .arg(grows("right"), words::compared(a.x, b.x), grows("up"), words::compared(a.y, b.y));
}

/// The near and the far edge of an axis.
QString exactNearAndFar(const SentenceContext& context)
{
    const TracedLine& tracedLine = context.tracedLine;
    const Side in = entryOf(tracedLine), out = exitOf(tracedLine);
    const bool isX = context.step.name == "xfar";
    return Text::tr(
               "So %1 is the near edge, where the line can enter, and %2 is the far edge, where it "
               "can leave.")
        .arg(edgeWords(isX ? in.x : in.y, tracedLine.y),
             edgeWords(isX ? out.x : out.y, tracedLine.y));
}

/// Whether an end is beyond the near or the far edge of an axis.
QString exactOneBeyond(const SentenceContext& context)
{
    const int number = context.at("enterX", "enterY") ? 1 : 2;
    const auto& end = number == 1 ? context.tracedLine.line.a : context.tracedLine.line.b;
    return (context.value(context.step.name) == 1.0 ? Text::tr("%1 is beyond %2 (%3).")
                                                    : Text::tr("%1 is not beyond %2 (%3)."))
        .arg(words::end(number), context.edgeText(),
             words::compared(end, context.edge(), context.tracedLine.window));
}

/// Whether the line passes the corner between an entry and an exit on the outside.
QString corner(const SentenceContext& context)
{
    const TracedLine& tracedLine = context.tracedLine;
    const Side in = entryOf(tracedLine), out = exitOf(tracedLine);
    const bool first = context.at("leavesYFirst");
    const QString entry = edgeWords(first ? in.x : in.y, tracedLine.y);
    const QString exit = edgeWords(first ? out.y : out.x, tracedLine.y);
    if (context.holds())
        return Text::tr(
                   "The line passes %1 before it reaches %2, so it passes the corner between them "
                   "on the outside. Rounding cannot change this decision.")
            .arg(exit, entry);
    if (first ? in.beyondX && out.beyondY : in.beyondY && out.beyondX)
        return Text::tr(
                   "The line reaches %2 no later than %1, so it does not pass the corner between "
                   "them on the outside. Rounding cannot change this decision.")
            .arg(exit, entry);
    return Text::tr("The line does not have to enter at %2 and leave at %1, so it cannot pass the "
                    "corner between them on the outside.")
        .arg(exit, entry);
}

/// At which of two edges an end is cut.
QString cutWhere(const SentenceContext& context)
{
    const TracedLine& tracedLine = context.tracedLine;
    const bool entering = context.at("end1AtX", "end1AtY");
    const Side side = entering ? entryOf(tracedLine) : exitOf(tracedLine);
    const QString end = words::end(entering ? 1 : 2);
    const QString x = edgeWords(side.x, tracedLine.y), y = edgeWords(side.y, tracedLine.y);
    const bool asksX = context.at("end1AtX", "end2AtX");
    if (!asksX)
        return context.holds() ? Text::tr("%1 is beyond %2: it is cut there.").arg(end, y)
                               : Text::tr("%1 is inside and stays as it is, bit for bit.").arg(end);
    if (!side.beyondX)
        return Text::tr("%1 is not beyond %2.").arg(end, x);
    if (!side.beyondY)
        return Text::tr("%1 is beyond %2 and no other edge: it is cut there.").arg(end, x);
    if (entering)
        return (context.holds()
                    ? Text::tr("Of the two edges where the line can enter, it passes %1 no "
                               "earlier than %2: End 1 is cut at %1.")
                    : Text::tr("Of the two edges where the line can enter, it passes %2 "
                               "later than %1: End 1 is not cut at %1."))
            .arg(x, y);
    return (context.holds()
                ? Text::tr("Of the two edges where the line can leave, it passes %1 no later "
                           "than %2: End 2 is cut at %1.")
                : Text::tr("Of the two edges where the line can leave, it passes %2 before "
                           "%1: End 2 is not cut at %1."))
        .arg(x, y);
}

QString exactGiven(const SentenceContext& context)
{
    const auto& name = context.step.name;
    return name == "up"                       ? exactDirection(context)
           : name == "xfar" || name == "yfar" ? exactNearAndFar(context)
                                              : exactOneBeyond(context);
}

QString exactSentence(const SentenceContext& context)
{
    const int end = context.at("move1ToX", "move1ToY") ? 1 : 2;
    switch (context.step.what) {
    case clipping::What::Accept:
        return words::accepted(context);
    case clipping::What::Reject:
        return Text::tr("Nothing of the line is visible, and that is certain.");
    case clipping::What::Cut:
        return Text::tr("%1 moves along the line to %2, to %3: the true point, rounded once.")
            .arg(words::end(end), context.edgeText(),
                 words::point(end == 1 ? context.step.segment.a : context.step.segment.b));
    case clipping::What::Test:
        return context.at("besideX", "besideY")             ? exactBothBeyond(context)
               : context.at("leavesYFirst", "leavesXFirst") ? corner(context)
                                                            : cutWhere(context);
    default:
        return exactGiven(context);
    }
}

constexpr auto exactVariables = std::to_array<VariableUnit>({
    {"xnear", ValueUnit::X},
    {"ynear", ValueUnit::Y},
    {"xfar", ValueUnit::X},
    {"yfar", ValueUnit::Y},
});

} // namespace

extern const Teaching exactTeaching;
const Teaching exactTeaching{
    .key = "exact",
    .sentence = exactSentence,
    .overlay = turnOverlay,
    .figure = {.line = {{-160, 10}, {-20, 120}}}, // close to a corner
    .variables = exactVariables,
};

} // namespace app
